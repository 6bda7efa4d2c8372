#include "gl/capture/mesh_builder.h"

#include "gl/capture/vertex_stream.h"
#include "gl/welding/weld.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gluray::gl {
namespace {

/// A capturedGrid of n x n squares as separate triangles without shared vertices.
CapturedVertices capturedGrid(uint32_t n, bool colored = false) {
  VertexStream stream;
  stream.start(bit(kPosition) | (colored ? bit(kColor) : 0), initialSlotValues());
  stream.begin(GL_TRIANGLES);
  const auto send = [&](uint32_t x, uint32_t y) {
    const float color[4] = {static_cast<float>(x % 256) / 255.0f, 0, 0, 1};
    if (colored) stream.set(kColor, color);
    stream.vertexSlow(static_cast<float>(x), static_cast<float>(y), std::sin(static_cast<float>(x * 31 + y)),
                      1);
  };
  for (uint32_t y = 0; y < n; ++y)
    for (uint32_t x = 0; x < n; ++x) {
      send(x, y), send(x + 1, y), send(x + 1, y + 1);
      send(x, y), send(x + 1, y + 1), send(x, y + 1);
    }
  stream.end();
  return stream.takeRun();
}

TEST(Weld, GivesOnlyEqualVerticesOneNumber) {
  const CapturedVertices c = capturedGrid(100);
  const Welded w = weld(c.vertices.data(), c.vertexCount, c.layout.stride);
  ASSERT_EQ(w.index.size(), c.vertexCount);
  EXPECT_EQ(w.source.size(), 101u * 101u);
  for (uint32_t i = 0; i < c.vertexCount; ++i)
    for (uint32_t k = 0; k < 3; ++k) ASSERT_EQ(c.vertex(w.source[w.index[i]])[k], c.vertex(i)[k]);
}

TEST(Weld, StaysExactOverSeveralBlocks) {
  const CapturedVertices c = capturedGrid(450);  // 1.2 million corners, more than one block
  const Welded w = weld(c.vertices.data(), c.vertexCount, c.layout.stride);
  EXPECT_LT(w.source.size(), 451u * 451u + 2000u);
  for (uint32_t i = 0; i < c.vertexCount; i += 97)
    ASSERT_EQ(c.vertex(w.source[w.index[i]])[0], c.vertex(i)[0]);
}

TEST(BuildMesh, KeepsTriangleOrderAndIdentityWithColours) {
  const CapturedVertices plain = capturedGrid(40), colored = capturedGrid(40, true);
  const KnownMesh a = buildMesh(plain), b = buildMesh(colored);
  ASSERT_TRUE(a.mesh && b.mesh);
  EXPECT_EQ(a.mesh->triangleCount, 3200u);
  EXPECT_EQ(a.mesh->geometryId, b.mesh->geometryId) << "colours are no part of the geometry";
  for (uint32_t t = 0; t < a.mesh->triangleCount; ++t)
    for (uint32_t k = 0; k < 3; ++k)
      ASSERT_EQ(a.mesh->position(a.mesh->corner(t, k)).x, plain.vertex(t * 3 + k)[0]);
}

TEST(BuildMesh, StoresColoursAsBytesOnlyWhereExact) {
  CapturedVertices c = capturedGrid(4, true);
  EXPECT_EQ(buildMesh(c).mesh->colors.format, scene::Format::unorm8x4);
  c.vertex(7)[c.layout.offset[kColor] + 1] = 0.1234567f;
  const KnownMesh exact = buildMesh(c);
  EXPECT_EQ(exact.mesh->colors.format, scene::Format::float4);
  EXPECT_EQ(scene::fetch(exact.mesh->colors, exact.mesh->corner(2, 1)).g, 0.1234567f);
}

/// `n` separate triangles with texture coordinates of the units in `slots`.
CapturedVertices layered(uint32_t n, SlotMask slots) {
  VertexStream stream;
  stream.start(bit(kPosition) | slots, initialSlotValues());
  stream.begin(GL_TRIANGLES);
  for (uint32_t i = 0; i < 3 * n; ++i) {
    const auto x = static_cast<float>(i);
    for (uint32_t unit = 0; unit < 8; ++unit) {
      const float values[] = {x, static_cast<float>(unit), 0, 1};
      if (slots & bit(texCoordSlot(unit))) stream.set(texCoordSlot(unit), values);
    }
    stream.vertexSlow(x, x * x, 0, 1);
  }
  stream.end();
  return stream.takeRun();
}

TEST(BuildMesh, KeepsTexcoordsOfHigherUnits) {
  const KnownMesh known = buildMesh(layered(5, bit(texCoordSlot(0)) | bit(texCoordSlot(3))));
  ASSERT_EQ(known.mesh->texcoordsAbove.size(), 3u);
  ASSERT_NE(known.mesh->texcoordsOf(0), nullptr);
  ASSERT_NE(known.mesh->texcoordsOf(3), nullptr);
  for (const uint32_t unit : {1u, 2u, 4u, 7u}) EXPECT_EQ(known.mesh->texcoordsOf(unit), nullptr) << unit;
  EXPECT_EQ(scene::fetch(*known.mesh->texcoordsOf(3), 7), glm::vec4(7, 3, 0, 1));
  EXPECT_EQ(scene::fetch(*known.mesh->texcoordsOf(0), 7), glm::vec4(7, 0, 0, 1));
}

TEST(BuildMesh, UnusedTextureUnitsTakeNoMemory) {
  const KnownMesh one = buildMesh(layered(5, bit(texCoordSlot(0)))),
                  two = buildMesh(layered(5, bit(texCoordSlot(0)) | bit(texCoordSlot(1))));
  EXPECT_TRUE(one.mesh->texcoordsAbove.empty());
  EXPECT_EQ(one.mesh->sizeBytes, 15u * (3 + 4) * 4);
  EXPECT_EQ(two.mesh->sizeBytes, 15u * (3 + 4 + 4) * 4);
}

TEST(BuildMesh, KnowsWhetherColoursAreOpaque) {
  CapturedVertices c = capturedGrid(4, true);
  EXPECT_TRUE(buildMesh(c).mesh->opaqueColors);
  c.vertex(3)[c.layout.offset[kColor] + 3] = 0.5f;
  EXPECT_FALSE(buildMesh(c).mesh->opaqueColors);
}

TEST(BuildMesh, BoundsIgnoreNonFiniteVertices) {
  CapturedVertices c = capturedGrid(4);
  c.vertex(0)[0] = NAN;
  c.vertex(1)[1] = INFINITY;
  const KnownMesh known = buildMesh(c);
  EXPECT_EQ(known.mesh->upper.x, 4);
  EXPECT_EQ(known.mesh->upper.y, 4);
}

TEST(BuildMesh, LeavesHomogeneousVerticesToTheRealOpenGL) {
  VertexStream stream;
  stream.start(bit(kPosition), initialSlotValues());
  stream.begin(GL_TRIANGLES);
  stream.vertexSlow(0, 0, 0, 1), stream.vertexSlow(1, 0, 0, 2), stream.vertexSlow(0, 1, 0, 1);
  stream.end();
  const KnownMesh known = buildMesh(stream.takeRun());
  EXPECT_TRUE(known.homogeneous);
  EXPECT_FALSE(known.mesh);
}

}  // namespace
}  // namespace gluray::gl
