#include "render/media/medium_lattice.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gluray::render {
namespace {

constexpr float kInfinite = std::numeric_limits<float>::infinity();

/// A box from 0 to 2 along each axis of data space, in `cells` cells along each.
template <class Value>
PlacedLattice boxOf(const glm::ivec3& cells, const Value& value,
                    const glm::mat4& worldFromData = glm::mat4(1)) {
  auto lattice = std::make_shared<Lattice>();
  lattice->size = cells;
  for (int z = 0; z < cells.z; ++z)
    for (int y = 0; y < cells.y; ++y)
      for (int x = 0; x < cells.x; ++x) lattice->values.push_back(value(x));
  const glm::mat4 dataFromWorld = glm::inverse(worldFromData);
  return {lattice, glm::scale(glm::mat4(1), glm::vec3(cells) / 2.0f) * dataFromWorld,
          glm::mat3(dataFromWorld)};
}

TEST(MediumLattice, HomogeneousMediaPassTheExponentialOfTheirLength) {
  const PlacedLattice box = boxOf({5, 7, 3}, [](int) { return 0.7f; });
  const auto passes = [&](const glm::vec3& origin, const glm::vec3& direction, float end) {
    return box.transmittance(origin, direction, end);
  };
  EXPECT_NEAR(passes({-3, 1, 1}, {1, 0, 0}, kInfinite), std::exp(-1.4f), 1e-5f);
  EXPECT_NEAR(passes({-3, 1, 1}, {10, 0, 0}, kInfinite), std::exp(-1.4f), 1e-5f)
      << "directions of any length";
  EXPECT_NEAR(passes({1, 1, 1}, {0, 0, -1}, kInfinite), std::exp(-0.7f), 1e-5f) << "from inside";
  EXPECT_NEAR(passes({-3, 1, 1}, {1, 0, 0}, 4), std::exp(-0.7f), 1e-5f) << "to inside";
  EXPECT_NEAR(passes({-1, -1, -1}, {1, 1, 1}, kInfinite), std::exp(-0.7f * std::sqrt(12.0f)), 1e-4f);
  EXPECT_EQ(passes({-3, 3, 1}, {1, 0, 0}, kInfinite), 1) << "past it";
  EXPECT_EQ(passes({-3, 1, 1}, {-1, 0, 0}, kInfinite), 1) << "away from it";
  EXPECT_EQ(passes({-3, 1, 1}, {1, 0, 0}, 2), 1) << "not up to it";
}

TEST(MediumLattice, LengthsAreThoseOfDataSpace) {
  const glm::mat4 worldFromData =
      glm::scale(glm::rotate(glm::translate(glm::mat4(1), {5, 0, 0}), 0.4f, {1, 2, 0}), glm::vec3(1, 1, 3));
  const PlacedLattice box = boxOf(
      {4, 4, 4}, [](int) { return 0.3f; }, worldFromData);
  const glm::vec3 from(worldFromData * glm::vec4(1, 1, -1, 1)), along(worldFromData * glm::vec4(0, 0, 1, 0));
  EXPECT_NEAR(box.transmittance(from, along, kInfinite), std::exp(-0.6f), 1e-5f);
}

TEST(MediumLattice, RampsAreIntegrated) {
  const PlacedLattice box = boxOf({8, 1, 1}, [](int x) { return static_cast<float>(x); });
  EXPECT_NEAR(box.transmittance({-1, 1, 1}, {1, 0, 0}, kInfinite), std::exp(-7.0f), 1e-4f);
  EXPECT_NEAR(box.extinction->at({2, 0.5f, 0.5f}), 1.5f, 1e-6f);
  EXPECT_NEAR(box.extinction->at({-2, 0.5f, 0.5f}), 0, 1e-6f);
}

TEST(MediumLattice, SeveralMediaMultiply) {
  const PlacedLattice box = boxOf({2, 2, 2}, [](int) { return 0.5f; });
  EXPECT_NEAR(transmittanceOf({box, box}, {-1, 1, 1}, {1, 0, 0}, kInfinite), std::exp(-2.0f), 1e-5f);
  EXPECT_EQ(transmittanceOf({}, {-1, 1, 1}, {1, 0, 0}, kInfinite), 1);
}

}  // namespace
}  // namespace gluray::render
