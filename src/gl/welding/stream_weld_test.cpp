#include "gl/welding/stream_weld.h"

#include "gl/capture/mesh_builder.h"
#include "gl/testing/test_soup.h"

#include <gtest/gtest.h>

#include <utility>

namespace gluray::gl {
namespace {

using namespace test;

/// Each test welds on the calling thread and on WeldBehind's.
class StreamWeld : public testing::TestWithParam<Welding> {};
INSTANTIATE_TEST_SUITE_P(Ways, StreamWeld, testing::Values(Welding::here, Welding::behind),
                         [](const auto& way) { return way.param == Welding::here ? "here" : "behind"; });

TEST_P(StreamWeld, WeldsLargeSoupsWhileTheyArrive) {
  for (const SlotMask slots :
       {bit(kPosition), bit(kPosition) | bit(kNormal), bit(kPosition) | bit(kNormal) | bit(kColor),
        bit(kPosition) | bit(kFogCoord)}) {
    const CapturedVertices soup = grid(kSide, kNever, slots),
                           welded = grid(kSide, kWeldFrom, slots, GetParam());
    EXPECT_TRUE(soup.indices.empty());
    EXPECT_EQ(welded.indices.size(), 6u * kSide * kSide);
    EXPECT_EQ(welded.vertexCount, (kSide + 1) * (kSide + 1));
    EXPECT_EQ(welded.primitives, soup.primitives);
    EXPECT_EQ(expanded(welded), expanded(soup));
  }
}

TEST(StreamWelder, DoesNotWeldSmallSoups) {
  EXPECT_TRUE(grid(20, kWeldFrom).indices.empty());
  EXPECT_TRUE(grid(kSide, 1'000'000).indices.empty());
}

TEST(StreamWelder, WeldsVerticesFromBeforeTheThresholdToo) {
  const CapturedVertices soup = grid(kSide, kNever), welded = grid(kSide, 6 * kSide * kSide - 1000);
  EXPECT_EQ(welded.indices.size(), 6u * kSide * kSide);
  EXPECT_EQ(welded.vertexCount, (kSide + 1) * (kSide + 1));
  EXPECT_EQ(expanded(welded), expanded(soup));
}

TEST_P(StreamWeld, IncompleteTrianglesAreDropped) {
  for (const uint32_t extra : {1u, 2u})
    for (const bool numbered : {false, true}) {
      VertexStream stream;
      stream.start(bit(kPosition), initialSlotValues(), kWeldFrom, GetParam());
      stream.begin(GL_TRIANGLES);
      sendGrid(stream, kSide);
      for (uint32_t i = 0; i < extra; ++i) stream.vertexSlow(-5, static_cast<float>(i), 0, 1);
      if (numbered) stream.captured();  // gives the extra vertices indices too
      stream.end();
      stream.begin(GL_TRIANGLES);
      for (int i = 0; i < 3; ++i) stream.vertexSlow(-7, static_cast<float>(i), 0, 1);
      stream.end();
      const CapturedVertices c = stream.takeRun();
      ASSERT_EQ(c.primitives, (std::vector<Primitive>{{GL_TRIANGLES, 0, 6 * kSide * kSide + 3}}));
      ASSERT_EQ(c.indices.size(), 6u * kSide * kSide + 3);
      EXPECT_EQ(c.vertex(c.indices[6 * kSide * kSide])[0], -7);
      EXPECT_EQ(c.vertex(c.indices[6 * kSide * kSide + 2])[1], 2);
    }
}

TEST_P(StreamWeld, OtherFiguresFollow) {
  VertexStream plain, welding;
  for (VertexStream* stream : {&plain, &welding}) {
    stream->start(bit(kPosition), initialSlotValues(), stream == &welding ? kWeldFrom : kNever, GetParam());
    stream->begin(GL_TRIANGLES), sendGrid(*stream, kSide), stream->end();
    stream->begin(GL_TRIANGLE_STRIP), sendGrid(*stream, 3), stream->end();
    stream->begin(GL_TRIANGLES), sendGrid(*stream, kSide), stream->end();
  }
  const CapturedVertices expected = plain.takeRun(), got = welding.takeRun();
  EXPECT_LT(got.vertexCount, expected.vertexCount);
  EXPECT_EQ(got.primitives, expected.primitives);
  EXPECT_EQ(expanded(got), expanded(expected));
  EXPECT_EQ(buildMesh(expected).mesh->geometryId, buildMesh(got).mesh->geometryId);
}

TEST_P(StreamWeld, ASlotSetLaterEndsTheWelding) {
  VertexStream stream;
  stream.start(bit(kPosition), initialSlotValues(), kWeldFrom, GetParam());
  stream.begin(GL_TRIANGLES), sendGrid(stream, kSide), stream.end();
  const uint32_t before = stream.captured().vertexCount;
  const float earlier[4] = {0, 0, 1, 0};
  stream.addSlot(kNormal, earlier);
  stream.begin(GL_TRIANGLES), sendGrid(stream, kSide), stream.end();
  const CapturedVertices c = stream.takeRun();
  const uint32_t at = c.layout.offset[kNormal], half = 6 * kSide * kSide;
  ASSERT_EQ(c.indices.size(), 2u * half);
  for (uint32_t i = 0; i < half; ++i) {
    ASSERT_LT(c.indices[i], before) << "earlier vertices keep their indices";
    ASSERT_GE(c.indices[half + i], before);
    ASSERT_EQ(c.vertex(c.indices[i])[at + 2], 1);
    ASSERT_EQ(c.vertex(c.indices[half + i])[0], c.vertex(c.indices[i])[0]);
  }
}

TEST_P(StreamWeld, MeshesTakeTheArraysOver) {
  CapturedVertices soup = grid(kSide, kNever),
                   welded = grid(kSide, kWeldFrom, bit(kPosition) | bit(kNormal), GetParam());
  const KnownMesh expected = buildMesh(soup), got = buildMesh(std::move(welded));
  ASSERT_TRUE(got.mesh);
  EXPECT_EQ(welded.vertices.data(), nullptr);
  EXPECT_EQ(welded.indices.size(), 0u);
  EXPECT_EQ(got.mesh->positions.stride, 24u);
  EXPECT_EQ(got.mesh->geometryId, expected.mesh->geometryId);
  EXPECT_EQ(got.mesh->upper, expected.mesh->upper);
  EXPECT_EQ(got.mesh->triangleCount, expected.mesh->triangleCount);
  EXPECT_LE(got.mesh->sizeBytes, expected.mesh->sizeBytes);
  for (uint32_t t = 0; t < got.mesh->triangleCount; t += 7)
    for (uint32_t k = 0; k < 3; ++k) {
      const uint32_t a = expected.mesh->corner(t, k), b = got.mesh->corner(t, k);
      ASSERT_EQ(expected.mesh->position(a), got.mesh->position(b));
      ASSERT_EQ(scene::fetch(expected.mesh->normals, a), scene::fetch(got.mesh->normals, b));
    }
}

TEST(StreamWelder, MayKeepVerticesTwiceIfTheyRecurLate) {
  StreamWelder welder;
  GrowingArray<uint32_t> indices;
  GrowingArray<float> vertices;
  constexpr uint32_t kCount = 1u << 21;
  vertices.resize(size_t{kCount} * 3);
  for (uint32_t i = 0; i < kCount; ++i)
    for (uint32_t k = 0; k < 3; ++k)
      vertices[size_t{i} * 3 + k] = static_cast<float>((i % (kCount / 2)) * (k + 1));
  const uint32_t kept = welder.weld(vertices.data(), 3, 0, vertices.data(), kCount, indices);
  EXPECT_GE(kept, kCount / 2);
  for (uint32_t i = 0; i < kCount; ++i)
    ASSERT_EQ(vertices[size_t{indices[i]} * 3 + 1], static_cast<float>((i % (kCount / 2)) * 2));
}

// Reads the run, adds to it, discards it and starts it again at many places within the pieces.
TEST_P(StreamWeld, RunsCanBeReadWhileTheyArrive) {
  const CapturedVertices soup = grid(kSide, kNever);
  VertexStream stream;
  for (const uint32_t step : {1000u, 8192u, 9001u, 50'000u}) {
    stream.start(bit(kPosition) | bit(kNormal), initialSlotValues(), kWeldFrom, GetParam());
    stream.begin(GL_TRIANGLES);
    sendGrid(stream, kSide);  // discarded
    stream.start(bit(kPosition) | bit(kNormal), initialSlotValues(), kWeldFrom, GetParam());
    EXPECT_TRUE(stream.empty());
    stream.begin(GL_TRIANGLES);
    uint32_t sent = 0;
    forEachCorner(kSide, [&](uint32_t x, uint32_t y) {
      const float normal[3] = {height(x, y), 0, 1};
      stream.set(kNormal, normal);
      stream.vertexSlow(static_cast<float>(x), static_cast<float>(y), height(y, x), 1);
      ASSERT_EQ(stream.openPrimitive().count, ++sent);
      if (sent % step == 0) { ASSERT_GT(stream.captured().vertexCount, 0u); }
    });
    stream.end();
    EXPECT_FALSE(stream.empty());
    const CapturedVertices c = stream.takeRun();
    EXPECT_EQ(c.primitives, soup.primitives);
    EXPECT_EQ(c.vertexCount, (kSide + 1) * (kSide + 1));
    EXPECT_EQ(expanded(c), expanded(soup));
    EXPECT_TRUE(stream.empty());
  }
}

}  // namespace
}  // namespace gluray::gl
