// Parts of a draw of instances contain all requested instances, in order, with the elements that they have in
// the whole draw.
#include "gl/culled/instances/instance_units.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace gluray::gl {
namespace {

using Parts = std::vector<std::array<uint32_t, 2>>;  // first, count

Parts partsOf(const InstanceUnits& units, const std::vector<uint64_t>& visible) {
  Parts parts;
  units.forParts(visible, [&](const InstancePart& part) { parts.push_back({part.first, part.count}); });
  return parts;
}

/// Instances that share an element are drawn together. The last unit may have fewer.
TEST(InstanceUnits, AreDrawnInRuns) {
  const InstanceUnits units(7, 388, {3, 3});
  ASSERT_EQ(units.units(), 130u);
  EXPECT_FALSE(units.areMixed());
  std::vector<uint64_t> visible(3, 0);
  for (const uint32_t unit : {0u, 1u, 63u, 64u, 65u, 129u}) visible[unit / 64] |= uint64_t{1} << (unit & 63);
  EXPECT_EQ(units.instancesIn(visible), 5u * 3 + 1);
  EXPECT_EQ(partsOf(units, visible), (Parts{{0, 6}, {189, 9}, {387, 1}}));
  EXPECT_EQ(units.element(129, 3), 7u + 129);
  EXPECT_EQ(units.endElement(3), 7u + 130);
}

TEST(InstanceUnits, WithoutArraysAreSingleInstances) {
  const InstanceUnits units(0, 5, {});
  EXPECT_EQ(units.units(), 5u);
  EXPECT_EQ(partsOf(units, {0b11011}), (Parts{{0, 2}, {3, 2}}));
}

/// Arrays with different divisors: a part ends where an array advances whose element does not begin with the
/// part.
TEST(InstanceUnits, AreCutWhereArraysAdvance) {
  const InstanceUnits units(0, 20, {1, 4});
  EXPECT_TRUE(units.areMixed());
  EXPECT_EQ(partsOf(units, {0b00001111111111111110}), (Parts{{1, 3}, {4, 12}}));
  EXPECT_EQ(partsOf(InstanceUnits(0, 24, {4, 6}), {0b111110}), (Parts{{2, 2}, {4, 2}, {6, 2}, {8, 4}}));
}

TEST(InstanceUnits, OfAllRatesHaveTheElementsOfTheWholeDraw) {
  std::mt19937 random(3);
  for (int round = 0; round < 300; ++round) {
    std::vector<uint32_t> divisors;
    for (uint32_t n = random() % 4; n > 0; --n) divisors.push_back(1 + random() % 9 * (1 + random() % 3));
    const uint32_t base = random() % 5, instances = 1 + random() % 300;
    const InstanceUnits units(base, instances, divisors);
    std::vector<uint64_t> visible((units.units() + 63) / 64);
    std::vector<bool> wanted(instances);
    const uint32_t rare = 1 + random() % 4;
    for (uint32_t i = 0; i < units.units(); ++i) {
      if (random() % 4 >= rare) continue;
      visible[i / 64] |= uint64_t{1} << (i & 63);
      const InstancePart part = units.part(i, i + 1);
      for (uint32_t k = 0; k < part.count; ++k) wanted[part.first + k] = true;
      for (const uint32_t d : divisors) {
        ASSERT_EQ(units.element(i, d), base + part.first / d);
        ASSERT_EQ(part.first / d, (part.first + part.count - 1) / d) << "one element in a unit";
      }
    }
    std::vector<bool> drawn(instances);
    uint32_t next = 0;
    for (const auto& [first, count] : partsOf(units, visible)) {
      ASSERT_GE(first, next);
      next = first + count;
      ASSERT_LE(next, instances);
      for (uint32_t i = 0; i < count; ++i) {
        drawn[first + i] = true;
        for (const uint32_t d : divisors) ASSERT_EQ(first / d + i / d, (first + i) / d);
      }
    }
    ASSERT_EQ(drawn, wanted);
    ASSERT_EQ(units.instancesIn(visible), static_cast<uint64_t>(std::ranges::count(wanted, true)));
  }
}

}  // namespace
}  // namespace gluray::gl
