#include "frame/pixels/hit_bands.h"

#include <gtest/gtest.h>

namespace gluray::frame {
namespace {

constexpr float kMiss = 2;

TEST(HitBands, NoHitsMakeNoBand) {
  EXPECT_TRUE(hitBands(std::vector<float>(100 * 70, kMiss).data(), 100, 70).empty());
}

TEST(HitBands, OnlyHitsMakeFullBands) {
  const auto bands = hitBands(std::vector<float>(100 * 70, 0.5f).data(), 100, 70);
  ASSERT_EQ(bands.size(), 5u);
  EXPECT_EQ(bands[0], (Band{0, 0, 100, 16}));
  EXPECT_EQ(bands[4], (Band{0, 64, 100, 6}));
}

TEST(HitBands, SpansTheHitsOfItsRows) {
  std::vector<float> depth(100 * 48, kMiss);
  depth[18 * 100 + 30] = 1;  // the far plane is a hit
  depth[20 * 100 + 7] = 0;
  depth[31 * 100 + 91] = 0.5f;
  const auto bands = hitBands(depth.data(), 100, 48);
  ASSERT_EQ(bands.size(), 1u);
  EXPECT_EQ(bands[0], (Band{7, 16, 85, 16}));
}

TEST(HitBands, ASingleHit) {
  for (const int at : {0, 5, 9}) {
    std::vector<float> depth(10, kMiss);
    depth[static_cast<size_t>(at)] = 0.5f;
    EXPECT_EQ(hitBands(depth.data(), 10, 1), (std::vector<Band>{{at, 0, 1, 1}}));
  }
}

TEST(HitBands, TallImagesHaveNoMoreThanTheLimit) {
  const auto bands = hitBands(std::vector<float>(4 * 5000, 0.5f).data(), 4, 5000);
  EXPECT_LE(bands.size(), static_cast<size_t>(kMaxBands));
  int rows = 0;
  for (const Band& b : bands) rows += b.height;
  EXPECT_EQ(rows, 5000);
}

}  // namespace
}  // namespace gluray::frame
