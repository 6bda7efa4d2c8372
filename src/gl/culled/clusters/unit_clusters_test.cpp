// Visible instances whose positions were captured are never skipped; invisible ones mostly are.
#include "gl/culled/clusters/unit_clusters.h"

#include "gl/testing/test_images.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace gluray::gl::culling_test {
namespace {

constexpr size_t kEach = 60;  // vertices of an instance

/// The first instance.
Primitives primitivesOf(const std::vector<glm::vec4>& positions, uint32_t triangles) {
  Primitives p;
  p.positions = reinterpret_cast<const std::byte*>(positions.data()), p.stride = sizeof(glm::vec4);
  p.components = 4, p.count = triangles;
  return p;
}

std::vector<glm::vec4> positionsOf(std::mt19937& random, size_t instances) {
  std::uniform_real_distribution<double> number(-1, 1);
  const glm::dmat4 view = randomView(random);
  std::vector<glm::vec4> all;
  for (size_t i = 0; i < instances; ++i) {
    const glm::dvec3 at(number(random), number(random), number(random));
    for (size_t v = 0; v < kEach; ++v) {
      const glm::dvec3 beside(number(random), number(random), number(random));
      all.emplace_back(view * glm::dvec4(at + 0.15 * beside, 1));
    }
  }
  return all;
}

TEST(UnitClusters, NeverMissOneThatIsNearerThanTheImage) {
  std::mt19937 random(4);
  uint64_t tested = 0, hidden = 0;
  for (int round = 0; round < 60; ++round) {
    constexpr uint32_t kCount = 150;
    const std::vector<glm::vec4> positions = positionsOf(random, kCount);
    const std::vector<float> depths = depthImage(random);
    DepthPyramid pyramid;
    pyramid.build(depths.data(), kWidth, kHeight);
    UnitClusters instances;
    const Primitives first = primitivesOf(positions, kEach / 3);
    instances.find(Clusters(first), first, kEach * sizeof(glm::vec4), kCount);
    std::vector<uint64_t> visible;
    instances.mayShow(window(), &pyramid, visible);
    for (uint32_t i = 0; i < kCount; ++i) {
      if (isSet(visible, i)) continue;
      ++hidden;
      for (size_t t = 0; t < kEach / 3; ++t) {
        std::array<glm::dvec4, 3> clip;
        for (size_t c = 0; c < 3; ++c) clip[c] = glm::dvec4(positions[kEach * i + 3 * t + c]);
        if (std::ranges::any_of(clip, [](const glm::dvec4& corner) { return !(corner.w > 0); })) continue;
        tested += expectBehind(WindowTriangle(clip), depths);
      }
    }
  }
  EXPECT_GT(hidden, 2000u);
  EXPECT_GT(tested, 10000u);
}

/// A unit of several instances has the positions of its first one. Positions that are not numbers are always
/// visible.
TEST(UnitClusters, OfUnitsAndOfNoNumbers) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const glm::vec4 hidden(0, 0, 0.9f, 1), shown(0, 0, -0.9f, 1), odd(0, nan, 0, 1), endless(INFINITY, 0, 0, 1);
  // Units of two instances of one triangle each, which is a point.
  std::vector<glm::vec4> positions;
  for (const glm::vec4& at : {hidden, shown, shown, hidden, odd, hidden, endless, hidden, hidden})
    positions.insert(positions.end(), 3, at);
  const Primitives first = primitivesOf(positions, 1);
  UnitClusters instances;
  instances.find(Clusters(first), first, 2 * 3 * sizeof(glm::vec4), 5);
  DepthPyramid pyramid;
  const std::vector<float> wall(static_cast<size_t>(kWidth) * kHeight, 0.5f);
  pyramid.build(wall.data(), kWidth, kHeight);
  WindowMapping pixels = window();
  pixels.sampleReach = 0.5;  // a point between pixel centres covers samples
  std::vector<uint64_t> visible;
  instances.mayShow(pixels, &pyramid, visible);
  EXPECT_EQ(visible, (std::vector<uint64_t>{0b01110}));
}

}  // namespace
}  // namespace gluray::gl::culling_test
