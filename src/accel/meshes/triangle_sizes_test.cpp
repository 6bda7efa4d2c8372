#include "accel/meshes/triangle_sizes.h"

#include "accel/testing/test_scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gluray::accel {
namespace {

using test::makeMesh;
using test::MeshData;
using test::squareData;

TEST(TriangleSizes, LongestEdgeOfAnyTriangle) {
  MeshData data = squareData();
  TriangleSizes sizes;
  EXPECT_FLOAT_EQ(sizes.longestEdge(*makeMesh(data)), std::sqrt(8.0f));
  const auto first = static_cast<uint32_t>(data.positions.size());
  data.indices.insert(data.indices.end(), {first, first + 1, first + 2});
  for (const glm::vec3 p : {glm::vec3(0), glm::vec3(0, 0, 1), glm::vec3(3, 0, 5)})
    data.positions.push_back(p);
  EXPECT_FLOAT_EQ(sizes.longestEdge(*makeMesh(data)), std::sqrt(34.0f));
}

TEST(TriangleSizes, IgnoresNanCorners) {
  MeshData data = squareData();
  data.positions[0].x = NAN;
  TriangleSizes sizes;
  EXPECT_GT(sizes.longestEdge(*makeMesh(data)), 0);
}

}  // namespace
}  // namespace gluray::accel
