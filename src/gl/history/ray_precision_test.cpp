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

/// A triangle of unit size at (far, far, 0), which the matrix brings back to the middle.
TEST(RayPrecision, RoundingsOfFarVerticesShowInTheWindow) {
  const auto isFar = [&](double far, double scale) {
    const auto at = static_cast<float>(far);
    const scene::MeshPtr mesh = test::meshOf({{at - 1, at, 0}, {at + 1, at, 0}, {at, at + 1, 0}});
    const glm::dmat4 matrix = glm::scale(kParallel, glm::dvec3(scale));
    return RayPrecision::isFarFromOrigin(*mesh, glm::translate(matrix, {-far, -far, 0}), kRaysViewport);
  };
  EXPECT_FALSE(isFar(0, 1));
  EXPECT_FALSE(isFar(1e3, 1));
  for (const double far : {1e6, 4e6, 1e7}) EXPECT_TRUE(isFar(far, 1)) << far;
  EXPECT_FALSE(isFar(1e6, 1e-3)) << "a thousandth of the size has a thousandth of the error";
  // A surface that extends from its origin to there is judged by its size (isTooLarge).
  const scene::MeshPtr wide = test::meshOf({{0, 0, 0}, {1e6f, 0, 0}, {1e6f, 1e6f, 0}});
  EXPECT_FALSE(RayPrecision::isFarFromOrigin(*wide, kParallel, kRaysViewport));
}

TEST(RayPrecision, InstancesThatArePlacedFarAwayAreRoundedThere) {
  const scene::MeshPtr mesh = square(1);
  const auto isFar = [&](double far) {
    const glm::dmat4 placed = glm::translate(glm::dmat4(1), {far, 0, 0});
    return RayPrecision::isFarFromOrigin(*mesh, glm::inverse(placed) * glm::dmat4(1), kRaysViewport, placed);
  };
  EXPECT_FALSE(isFar(0));
  EXPECT_FALSE(isFar(100));
  EXPECT_TRUE(isFar(1e6));
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
