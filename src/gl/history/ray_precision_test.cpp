#include "gl/history/ray_precision.h"

#include "gl/testing/test_mesh.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

const glm::ivec2 kRaysViewport(300, 200);
const glm::dmat4 kParallel = glm::ortho(-5.0, 5.0, -5.0, 5.0, -100.0, 100.0);

scene::MeshPtr square(float size) {
  return test::meshOf({{-size, -size, 0}, {size, -size, 0}, {size, size, 0}});
}

TEST(RayPrecision, DependsOnHowMuchLargerTrianglesAreThanPixels) {
  RayPrecision precision;
  EXPECT_FALSE(precision.isTooLarge(*square(5), kParallel, kRaysViewport));
  EXPECT_FALSE(precision.isTooLarge(*square(5000), kParallel, kRaysViewport));
  EXPECT_TRUE(precision.isTooLarge(*square(1e6f), kParallel, kRaysViewport));
  // The matrix scales it down to the size of the first one.
  EXPECT_FALSE(precision.isTooLarge(*square(1e6f), glm::scale(kParallel, glm::dvec3(1e-5)), kRaysViewport));
}

TEST(RayPrecision, MeshesBeyondTheRangeOfFloatsAreMissed) {
  RayPrecision precision;
  const auto isRefused = [&](double size) {
    return precision.isTooLarge(*square(static_cast<float>(size)),
                                glm::scale(kParallel, glm::dvec3(1 / size)), kRaysViewport);
  };
  for (const double size : {1e-11, 1e-6, 1e6, 1e10}) EXPECT_FALSE(isRefused(size)) << size;
  for (const double size : {1e-20, 1e-13, 1e12, 1e20}) EXPECT_TRUE(isRefused(size)) << size;
}

TEST(RayPrecision, DependsOnTheNearestVisiblePoint) {
  RayPrecision precision;
  const glm::dmat4 projection = glm::perspective(0.8, 1.5, 0.1, 1e7);
  const scene::MeshPtr mesh = square(1e5f);
  const auto seenFrom = [&](double distance) {
    return precision.isTooLarge(*mesh, glm::translate(projection, {0, 0, -distance}), kRaysViewport);
  };
  EXPECT_TRUE(seenFrom(1));
  EXPECT_FALSE(seenFrom(1e5));
  // A floor near the viewer, and one behind the viewer.
  EXPECT_TRUE(precision.isTooLarge(
      *mesh, projection * glm::lookAt(glm::dvec3(0, 0, 1), {1, 1, 0.9}, {0, 0, 1}), kRaysViewport));
  EXPECT_FALSE(precision.isTooLarge(
      *mesh, projection * glm::lookAt(glm::dvec3(0, 0, 1), {0, 0, 2}, {0, 1, 0}), kRaysViewport));
}

TEST(RayPrecision, IgnoresPartsInFrontOfTheNearPlane) {
  const glm::dmat4 eyeFromObject =
      glm::lookAt(glm::dvec3(0, 0, 1), glm::dvec3(1, 1, 0.9), glm::dvec3(0, 0, 1));
  scene::Mesh mesh = *square(50);  // a floor under the viewer
  RayPrecision precision;
  EXPECT_FALSE(
      precision.isTooLarge(mesh, glm::perspective(0.8, 1.5, 0.1, 1e7) * eyeFromObject, kRaysViewport));
  EXPECT_FALSE(
      precision.isTooLarge(mesh, glm::infinitePerspective(0.8, 1.5, 0.1) * eyeFromObject, kRaysViewport));
  // The bounds suffice: no triangle is read.
  mesh.geometryId.low += 1;
  mesh.positions.data = nullptr;
  EXPECT_FALSE(
      precision.isTooLarge(mesh, glm::perspective(0.8, 1.5, 0.1, 1e7) * eyeFromObject, kRaysViewport));
}

TEST(RayPrecision, SmallTrianglesOfALargeMeshAreFine) {
  RayPrecision precision;
  std::vector<glm::vec3> corners;
  for (int i = 0; i < 2000; ++i) {
    const auto at = static_cast<float>(i - 1000) * 1000;
    corners.insert(corners.end(), {{at, 0, 0}, {at + 1, 0, 0}, {at, 1, 0}});
  }
  EXPECT_FALSE(precision.isTooLarge(*test::meshOf(corners), kParallel, kRaysViewport));
  corners.insert(corners.end(), {{-1e6f, -1, 0}, {1e6f, -1, 0}, {1e6f, 1, 0}});
  EXPECT_TRUE(precision.isTooLarge(*test::meshOf(corners), kParallel, kRaysViewport));
}

}  // namespace
}  // namespace gluray::gl
