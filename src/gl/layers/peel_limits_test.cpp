#include "gl/layers/peel_limits.h"

#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

constexpr uint64_t kPixels = 100'000;

/// `pixels` pixels with `n` layers and nothing opaque behind.
LayerCounts open(size_t n, uint32_t pixels) {
  LayerCounts counts;
  counts.open[n] = pixels;
  return counts;
}

/// `pixels` pixels with `n` layers in front of something opaque.
LayerCounts before(size_t n, uint32_t pixels) {
  LayerCounts counts;
  counts.before[n] = pixels;
  return counts;
}

TEST(PeelLimits, CountsFarthestLayersWritten) {
  EXPECT_EQ(writtenBehind(open(1, 10), 1), 0u);
  EXPECT_EQ(writtenBehind(open(2, 10), 1), 10u);
  EXPECT_EQ(writtenBehind(open(3, 10), 2), 0u);
  EXPECT_EQ(writtenBehind(open(4, 10), 2), 10u);
  EXPECT_EQ(writtenBehind(before(5, 10), 1), 0u);
  EXPECT_EQ(writtenBehind(before(2, 10), 2), 0u);
  EXPECT_EQ(writtenBehind(before(3, 10), 2), 10u);
}

TEST(PeelLimits, KnowsWhenPeelsShowAllLayers) {
  EXPECT_TRUE(showsAll(1, open(2, 5000), kPixels));
  EXPECT_FALSE(showsAll(1, open(3, 5000), kPixels));
  EXPECT_TRUE(showsAll(2, open(4, 5000), kPixels));
  EXPECT_FALSE(showsAll(5, open(12, 5000), kPixels));
  EXPECT_TRUE(showsAll(6, open(12, 5000), kPixels));
  // The opaque depth takes a farthest layer's place.
  EXPECT_FALSE(showsAll(1, before(2, 5000), kPixels));
  EXPECT_TRUE(showsAll(2, before(3, 5000), kPixels));
  EXPECT_TRUE(showsAll(1, open(3, 100), kPixels));
}

TEST(PeelLimits, CountsAtSilhouettesAreUncertain) {
  EXPECT_EQ(surelyWritten(open(4, 5000), 2), 5000u);
  EXPECT_EQ(surelyWritten(open(4, 31), 2), std::nullopt);
  EXPECT_EQ(surelyWritten(before(4, 5000), 1), std::nullopt);
}

}  // namespace
}  // namespace gluray::gl
