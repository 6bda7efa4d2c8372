#include "gl/history/coincident_meshes.h"

#include "gl/testing/test_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace gluray::gl {
namespace {

/// Two triangles for each square of a strip of `squares`, which begins at x = `first`.
std::vector<glm::vec3> strip(int first, int squares, float z = 0) {
  std::vector<glm::vec3> corners;
  for (int i = first; i < first + squares; ++i) {
    const auto x = static_cast<float>(i);
    const glm::vec3 a(x, 0, z), b(x + 1, 0, z), c(x + 1, 1, z), d(x, 1, z);
    corners.insert(corners.end(), {a, b, c, a, c, d});
  }
  return corners;
}

TEST(CoincidentMeshes, ShareTriangles) {
  CoincidentMeshes meshes;
  const scene::MeshPtr all = test::meshOf(strip(0, 400)), part = test::meshOf(strip(7, 3));
  EXPECT_TRUE(meshes.coincide(*all, *all));
  EXPECT_TRUE(meshes.coincide(*all, *part));
  EXPECT_TRUE(meshes.coincide(*part, *all));
  EXPECT_TRUE(meshes.coincide(*part, *all)) << "the remembered answer";
}

TEST(CoincidentMeshes, RotatedCornersAreTheSameTriangle) {
  std::vector<glm::vec3> corners = strip(0, 4);
  for (size_t t = 0; t < corners.size(); t += 3)
    std::rotate(corners.begin() + static_cast<ptrdiff_t>(t), corners.begin() + static_cast<ptrdiff_t>(t) + 1,
                corners.begin() + static_cast<ptrdiff_t>(t) + 3);
  CoincidentMeshes meshes;
  EXPECT_TRUE(meshes.coincide(*test::meshOf(strip(0, 4)), *test::meshOf(corners)));
}

/// As where two solids touch.
TEST(CoincidentMeshes, OppositeOrientationsAreNone) {
  std::vector<glm::vec3> corners = strip(0, 4);
  for (size_t t = 0; t < corners.size(); t += 3) std::swap(corners[t], corners[t + 1]);
  CoincidentMeshes meshes;
  EXPECT_FALSE(meshes.coincide(*test::meshOf(strip(0, 4)), *test::meshOf(corners)));
}

TEST(CoincidentMeshes, NeighboursAndOtherTrianglesAreNone) {
  CoincidentMeshes meshes;
  const scene::MeshPtr mesh = test::meshOf(strip(0, 4));
  EXPECT_FALSE(meshes.coincide(*mesh, *test::meshOf(strip(4, 4))));
  EXPECT_FALSE(meshes.coincide(*mesh, *test::meshOf(strip(0, 4, 0.5f))));
  EXPECT_FALSE(meshes.coincide(*mesh, *test::meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})))
      << "another diagonal";
}

}  // namespace
}  // namespace gluray::gl
