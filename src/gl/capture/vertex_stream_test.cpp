#include "gl/capture/vertex_stream.h"

#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

void triangle(VertexStream& stream, float x) {
  stream.begin(GL_TRIANGLES);
  for (int i = 0; i < 3; ++i) stream.vertexSlow(x, static_cast<float>(i), 0, 1);
  stream.end();
}

TEST(VertexStream, JoinsSeparatePrimitivesOfOneMode) {
  VertexStream stream;
  stream.start(bit(kPosition), initialSlotValues());
  triangle(stream, 0);
  triangle(stream, 1);
  EXPECT_EQ(stream.captured().primitives, (std::vector<Primitive>{{GL_TRIANGLES, 0, 6}}));
  stream.begin(GL_TRIANGLE_STRIP);
  for (int i = 0; i < 4; ++i) stream.vertexSlow(0, 0, 0, 1);
  stream.end();
  EXPECT_EQ(stream.captured().primitives.back(), (Primitive{GL_TRIANGLE_STRIP, 6, 4}));
}

TEST(VertexStream, AddSlotFillsEarlierVertices) {
  VertexStream stream;
  stream.start(bit(kPosition), initialSlotValues());
  triangle(stream, 0);
  const float white[4] = {1, 1, 1, 1}, red[4] = {1, 0, 0, 1};
  stream.addSlot(kColor, white);
  stream.set(kColor, red);
  triangle(stream, 5);
  const CapturedVertices c = stream.takeRun();
  ASSERT_EQ(c.vertexCount, 6u);
  const uint32_t at = c.layout.offset[kColor];
  EXPECT_EQ(c.vertex(2)[at + 1], 1);
  EXPECT_EQ(c.vertex(3)[at + 1], 0);
  EXPECT_EQ(c.vertex(3)[0], 5);
  EXPECT_EQ(c.vertex(5)[1], 2);
}

TEST(VertexStream, KeepsItsMemoryFromRunToRun) {
  VertexStream stream;
  const float* data = nullptr;
  size_t capacity = 0;
  for (int run = 0; run < 3; ++run) {
    stream.start(bit(kPosition), initialSlotValues());
    const float up[4] = {0, 0, 1, 0};
    stream.addSlot(kNormal, up);  // as the first glNormal of a run does
    for (int i = 0; i < 100'000; ++i) triangle(stream, static_cast<float>(i));
    const CapturedVertices& c = stream.captured();
    if (run > 0) {
      EXPECT_EQ(c.vertices.data(), data);
      EXPECT_EQ(c.vertices.capacity(), capacity);
    }
    data = c.vertices.data(), capacity = c.vertices.capacity();
    EXPECT_EQ(c.vertex(299'999)[0], 99'999);
    EXPECT_EQ(c.vertex(299'999)[c.layout.offset[kNormal] + 2], 1);
  }
}

TEST(VertexStream, WidensEarlierVerticesInPlace) {
  VertexStream stream;
  stream.start(bit(kPosition), initialSlotValues());
  for (int i = 0; i < 50; ++i) triangle(stream, static_cast<float>(i));
  const float white[4] = {1, 1, 1, 1}, st[4] = {3, 4, 0, 1};
  stream.addSlot(kColor, white);
  stream.addSlot(kTexCoord0, st);
  const CapturedVertices c = stream.takeRun();
  ASSERT_EQ(c.vertexCount, 150u);
  for (uint32_t i = 0; i < c.vertexCount; ++i) {
    EXPECT_EQ(c.vertex(i)[0], static_cast<float>(i / 3));
    EXPECT_EQ(c.vertex(i)[1], static_cast<float>(i % 3));
    EXPECT_EQ(c.vertex(i)[c.layout.offset[kColor] + 3], 1);
    EXPECT_EQ(c.vertex(i)[c.layout.offset[kTexCoord0] + 1], 4);
  }
}

TEST(VertexStream, StoresWOnlyIfAVertexNeedsIt) {
  VertexStream stream;
  stream.start(bit(kPosition), initialSlotValues());
  triangle(stream, 0);
  EXPECT_FALSE(stream.has(kPositionW));
  stream.begin(GL_POINTS);
  stream.vertexSlow(1, 2, 3, 4);
  stream.vertexSlow(1, 2, 3, 1);
  EXPECT_FALSE(stream.hasRoom()) << "vertex() would lose w";
  stream.end();
  const CapturedVertices c = stream.takeRun();
  const uint32_t at = c.layout.offset[kPositionW];
  EXPECT_EQ(c.vertex(0)[at], 1);
  EXPECT_EQ(c.vertex(3)[at], 4);
  EXPECT_EQ(c.vertex(4)[at], 1);
}

TEST(VertexStream, HasRoomOnlyInsideAPrimitive) {
  VertexStream stream;
  stream.start(bit(kPosition), initialSlotValues());
  triangle(stream, 0);
  EXPECT_FALSE(stream.hasRoom());
  stream.begin(GL_TRIANGLES);
  EXPECT_TRUE(stream.hasRoom());
}

TEST(VertexStream, HoldsEverySlotAtOnce) {
  VertexStream stream;
  SlotValues values = initialSlotValues();
  for (size_t s = 0; s < kSlotCount; ++s) values[s] = {static_cast<float>(s), 1, 2, 3};
  stream.start(~SlotMask{0} & ~bit(kPositionW), values);
  stream.begin(GL_POINTS);
  for (int i = 0; i < 3000; ++i) stream.vertexSlow(static_cast<float>(i), 0, 0, 1);
  stream.end();
  const CapturedVertices c = stream.takeRun();
  for (const uint32_t i : {0u, 1500u, 2999u}) {
    EXPECT_EQ(c.vertex(i)[0], static_cast<float>(i));
    for (int s = kNormal; s < kSlotCount; ++s)
      EXPECT_EQ(c.vertex(i)[c.layout.offset[s]], static_cast<float>(s));
  }
}

TEST(VertexStream, NumbersMaterialChangesOnce) {
  VertexStream stream;
  stream.start(bit(kPosition), initialSlotValues());
  MaterialChange change;
  const float red[4] = {1, 0, 0, 1};
  change.set(GL_FRONT, GL_AMBIENT, red);
  EXPECT_EQ(stream.addMaterial(change), 1);
  EXPECT_EQ(stream.addMaterial(change), 1);
  change.set(GL_BACK, GL_AMBIENT, red);
  EXPECT_EQ(stream.addMaterial(change), 2);
}

}  // namespace
}  // namespace gluray::gl
