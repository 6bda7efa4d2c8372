#include "frame/pixels/pixel_rows.h"

#include "base/image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>
#include <vector>

namespace gluray::frame {
namespace {

constexpr size_t kMax = 77;  // pixels: several vectors of any instruction set, and a remainder

/// Depths, including those of the near and far planes; a third are misses.
std::vector<float> someDepths(uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<float> depths(kMax);
  for (float& depth : depths) {
    const uint32_t r = random();
    depth = r % 3 == 0 ? Image::kMiss : r % 5 == 0 ? 1.0f : r % 7 == 0 ? 0.0f : std::ldexp(float(r), -32);
  }
  return depths;
}

TEST(PixelRows, HitsAreFoundFromBothEnds) {
  for (size_t count = 0; count <= kMax; ++count) {
    std::vector<float> depths(kMax, Image::kMiss);
    depths.resize(count);
    EXPECT_EQ(firstHit(depths.data(), count), count);
    EXPECT_EQ(endOfHits(depths.data(), count), 0u);
    for (size_t at = 0; at < count; ++at) {
      depths[at] = at % 2 == 0 ? 1.0f : 0.0f;
      depths[at / 2] = 0.5f;  // another hit before it
      EXPECT_EQ(firstHit(depths.data(), count), at / 2);
      EXPECT_EQ(endOfHits(depths.data(), count), at + 1);
      std::fill(depths.begin(), depths.end(), Image::kMiss);
    }
  }
}

TEST(PixelRows, PixelsBeyondTheRowAreIgnored) {
  std::vector<float> depths(kMax, 0.5f);
  std::fill_n(depths.begin() + 8, 19, Image::kMiss);
  EXPECT_EQ(firstHit(&depths[8], 19), 19u);
  EXPECT_EQ(endOfHits(&depths[8], 19), 0u);
}

TEST(PixelRows, DepthsOf24BitsAreRoundedToTheNearest) {
  for (uint32_t seed = 0; seed < 20; ++seed) {
    const std::vector<float> depths = someDepths(seed);
    for (const size_t count : {size_t{0}, size_t{1}, size_t{16}, kMax}) {
      std::vector<uint32_t> stored(kMax, 7);
      toDepth24(depths.data(), count, stored.data());
      for (size_t i = 0; i < kMax; ++i) {
        const float product = std::min(depths[i], 1.0f) * 16777215.0f;
        const auto expected = static_cast<uint32_t>(std::nearbyint(double{product})) << 8;
        EXPECT_EQ(stored[i], i < count ? expected : 7u) << depths[i];
      }
    }
  }
}

TEST(PixelRows, DepthsOfFloatsKeepTheirBits) {
  const std::vector<float> depths = someDepths(1);
  std::vector<uint32_t> stored(kMax);
  toDepthFloat(depths.data(), kMax, stored.data());
  for (size_t i = 0; i < kMax; ++i) EXPECT_EQ(stored[i], std::bit_cast<uint32_t>(std::min(depths[i], 1.0f)));
}

TEST(PixelRows, WindowsShowColorsWhereDepthsAreNear) {
  std::mt19937 random(3);
  std::vector<uint32_t> colors(kMax);
  std::generate(colors.begin(), colors.end(), random);
  const std::vector<float> depths = someDepths(2);
  for (const float farthest : {1.0f, 0.5f, 0.0f}) {
    std::vector<uint32_t> shown(kMax);
    toWindow(colors.data(), depths.data(), farthest, 0x11223344u, kMax, shown.data());
    for (size_t i = 0; i < kMax; ++i) {
      const uint32_t rgba = depths[i] <= farthest ? colors[i] : 0x11223344u;
      const uint32_t red = rgba & 255, blue = rgba >> 16 & 255;
      EXPECT_EQ(shown[i], rgba - red - (blue << 16) + (red << 16) + blue);
    }
  }
}

}  // namespace
}  // namespace gluray::frame
