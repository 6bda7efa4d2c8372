// Generated texture coordinates against closed-form values.
#include "render/local/texgen.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gluray {
namespace {

using render::TexGenVertex;
using scene::TexGen;

constexpr float kCoordinateTolerance = 1e-6f;

glm::vec4 all(TexGen::Mode mode, const TexGenVertex& v, glm::vec4 plane = glm::vec4(0)) {
  TexGen gen;
  for (TexGen::Coordinate& c : gen.coordinates) c = {mode, plane};
  return render::generateCoordinates(gen, v, glm::vec4(9));
}

TEST(TexGen, PlanesInObjectAndEyeSpace) {
  const TexGenVertex v{{1, 2, 3, 1}, {4, 5, 6}, {0, 0, 1}};
  EXPECT_FLOAT_EQ(all(TexGen::objectLinear, v, {1, 10, 100, 1000}).x, 1321);
  EXPECT_FLOAT_EQ(all(TexGen::eyeLinear, v, {1, 10, 100, 1000}).y, 1654);
}

TEST(TexGen, SphereMap) {
  const TexGenVertex facing{{}, {0, 0, -5}, {0, 0, 1}};  // faces the eye: the middle of the map
  EXPECT_NEAR(all(TexGen::sphereMap, facing).x, 0.5f, kCoordinateTolerance);
  EXPECT_NEAR(all(TexGen::sphereMap, facing).y, 0.5f, kCoordinateTolerance);
  const float half = std::sqrt(0.5f);
  const TexGenVertex turned{
      {}, {0, 0, -5}, {half, 0, half}};  // reflects to +x: 1 / (2 sqrt(2)) from the middle
  EXPECT_NEAR(all(TexGen::sphereMap, turned).x, 0.5f + 0.35355339f, kCoordinateTolerance);
  EXPECT_NEAR(all(TexGen::sphereMap, turned).y, 0.5f, kCoordinateTolerance);
}

TEST(TexGen, Directions) {
  const float half = std::sqrt(0.5f);
  const TexGenVertex v{{}, {0, 0, -2}, {half, 0, half}};
  const glm::vec4 reflected = all(TexGen::reflectionMap, v), normal = all(TexGen::normalMap, v);
  EXPECT_NEAR(reflected.x, 1, kCoordinateTolerance);
  EXPECT_NEAR(reflected.y, 0, kCoordinateTolerance);
  EXPECT_NEAR(reflected.z, 0, kCoordinateTolerance);
  EXPECT_NEAR(normal.x, half, kCoordinateTolerance);
  EXPECT_NEAR(normal.z, half, kCoordinateTolerance);
}

TEST(TexGen, UngeneratedCoordinatesAreKept) {
  TexGen gen;
  gen.coordinates[1] = {TexGen::objectLinear, {0, 0, 0, 7}};
  EXPECT_EQ(render::generateCoordinates(gen, {}, {1, 2, 3, 4}), glm::vec4(1, 7, 3, 4));
  EXPECT_TRUE(gen.on());
  EXPECT_FALSE(render::needsNormal(gen));
  EXPECT_FALSE(TexGen{}.on());
}

TEST(TexGen, VertexAtTheEyeIsFinite) {
  const glm::vec4 c = all(TexGen::sphereMap, TexGenVertex{});
  EXPECT_TRUE(std::isfinite(c.x) && std::isfinite(c.y));
}

}  // namespace
}  // namespace gluray
