#include "gl/capture/captured_vertices.h"

#include "gl/capture/vertex_stream.h"

#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

/// Vertices 0 .. n-1 in a row, as one primitive.
CapturedVertices row(GLenum mode, uint32_t n) {
  VertexStream stream;
  stream.start(bit(kPosition), initialSlotValues());
  stream.begin(mode);
  for (uint32_t i = 0; i < n; ++i) stream.vertexSlow(static_cast<float>(i), 0, 0, 1);
  stream.end();
  return stream.takeRun();
}

using Corners = std::vector<uint32_t>;

TEST(Triangulate, EndsEachTriangleWithItsProvokingVertex) {
  EXPECT_EQ(triangulate(row(GL_TRIANGLES, 6)), (Corners{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(triangulate(row(GL_TRIANGLE_STRIP, 5)), (Corners{0, 1, 2, 2, 1, 3, 2, 3, 4}));
  EXPECT_EQ(triangulate(row(GL_TRIANGLE_FAN, 4)), (Corners{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(triangulate(row(GL_POLYGON, 4)), (Corners{1, 2, 0, 2, 3, 0}));
  EXPECT_EQ(triangulate(row(GL_QUADS, 4)), (Corners{0, 1, 3, 1, 2, 3}));
  EXPECT_EQ(triangulate(row(GL_QUAD_STRIP, 6)), (Corners{0, 1, 3, 2, 0, 3, 2, 3, 5, 4, 2, 5}));
}

TEST(Triangulate, LinesAndPointsHaveNoTriangles) {
  for (const GLenum mode : {GL_POINTS, GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP})
    EXPECT_TRUE(triangulate(row(mode, 6)).empty());
}

TEST(Triangulate, DropsIncompletePrimitives) {
  EXPECT_EQ(row(GL_TRIANGLES, 5).vertexCount, 3u);
  EXPECT_EQ(row(GL_QUADS, 7).vertexCount, 4u);
  EXPECT_EQ(row(GL_QUAD_STRIP, 5).vertexCount, 4u);
  EXPECT_TRUE(row(GL_TRIANGLE_STRIP, 2).empty());
  EXPECT_TRUE(row(GL_POLYGON, 0).empty());
}

TEST(Triangulate, AgreesWithCountTriangles) {
  for (const GLenum mode :
       {GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_POLYGON, GL_QUADS, GL_QUAD_STRIP})
    for (uint32_t n = 0; n < 14; ++n) {
      const CapturedVertices c = row(mode, n);
      EXPECT_EQ(triangulate(c).size(), countTriangles(c) * 3) << mode << " with " << n;
    }
}

TEST(Captured, HashDependsOnAllContent) {
  const Hash128 base = row(GL_TRIANGLES, 6).hash();
  EXPECT_EQ(row(GL_TRIANGLES, 6).hash(), base);
  EXPECT_NE(row(GL_TRIANGLES, 3).hash(), base);
  EXPECT_NE(row(GL_TRIANGLE_STRIP, 6).hash(), base);
  CapturedVertices moved = row(GL_TRIANGLES, 6);
  moved.vertex(5)[2] = 1e-30f;
  EXPECT_NE(moved.hash(), base);
}

TEST(MaterialChange, SinceKeepsOnlyNewParameters) {
  const float red[4] = {1, 0, 0, 1}, blue[4] = {0, 0, 1, 1};
  MaterialChange earlier;
  earlier.set(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, red);
  MaterialChange later = earlier;
  later.set(GL_FRONT, GL_DIFFUSE, blue), later.set(GL_BACK, GL_EMISSION, red);
  const MaterialChange since = later.since(earlier);
  EXPECT_EQ(since.front, MaterialChange::diffuse);
  EXPECT_EQ(since.values.front.diffuse, glm::vec4(0, 0, 1, 1));
  EXPECT_EQ(since.back, MaterialChange::emission);
  EXPECT_EQ(later.since({}).front, later.front);
}

TEST(MaterialChange, AppliesOnlyParametersThatWereSet) {
  MaterialChange change;
  const float red[4] = {1, 0, 0, 1}, shine = 7;
  ASSERT_TRUE(change.set(GL_FRONT, GL_DIFFUSE, red));
  ASSERT_TRUE(change.set(GL_BACK, GL_SHININESS, &shine));
  EXPECT_FALSE(change.set(GL_FRONT, GL_POSITION, red));
  EXPECT_FALSE(change.set(GL_LEFT, GL_DIFFUSE, red));
  scene::MaterialPair base;
  base.front.specular = {0.25f, 0.5f, 0.75f, 1};
  const scene::MaterialPair result = change.appliedTo(base);
  EXPECT_EQ(result.front.diffuse, glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(result.front.specular, base.front.specular);
  EXPECT_EQ(result.back.diffuse, base.back.diffuse);
  EXPECT_EQ(result.back.shininess, 7);
  EXPECT_EQ(result.front.shininess, base.front.shininess);
}

}  // namespace
}  // namespace gluray::gl
