#include "render/resolve/resolve_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gluray::render {
namespace {

constexpr uint32_t kBack = 0xFF102030u;

/// One pixel of four samples at (1, 2).
Image fourSamples(std::array<uint32_t, 4> colors, std::array<float, 4> depths) {
  Image image;
  image.resize(1, 1, 4);
  image.x = 1, image.y = 2;
  std::copy(colors.begin(), colors.end(), image.color.begin());
  std::copy(depths.begin(), depths.end(), image.depth.begin());
  return image;
}

size_t place(const Image& image, size_t x, size_t y) { return y * static_cast<size_t>(image.width) + x; }

TEST(Resolve, MissesAreBackgroundAndEqualSamplesKeepTheirColour) {
  const Image samples = fourSamples({7, 7, 7, 7}, {0.5f, 0.6f, 0.7f, 0.8f});
  Image out;
  resolve({{3, 4}, kBack, 1, 2.2f}, samples, out);
  ASSERT_EQ(out.color.size(), 12u);
  for (size_t y = 0; y < 4; ++y)
    for (size_t x = 0; x < 3; ++x) {
      const bool here = x == 1 && y == 2;
      EXPECT_EQ(out.color[place(out, x, y)], here ? 7u : kBack) << x << " " << y;
      EXPECT_EQ(out.depth[place(out, x, y)], here ? 0.5f : 1.0f) << x << " " << y;
    }
}

TEST(Resolve, ColorsAreAveragedWithTheBackgroundDepthIsTheFirstSamples) {
  const float miss = Image::kMiss;
  const Image samples = fourSamples({0xFF0000FFu, 0, 0xFF0000FFu, 0}, {miss, miss, 0.25f, miss});
  Image out;
  resolve({{3, 4}, 0xFF000000u, 1, 1}, samples, out);
  EXPECT_EQ(out.color[place(out, 1, 2)], 0xFF000040u);  // 255 / 4, rounded
  EXPECT_EQ(out.depth[place(out, 1, 2)], 1.0f);
}

TEST(Resolve, AveragesColoursWithGammaAndAlphaWithout) {
  const Image samples = fourSamples({0xFF0000FFu, 0, 0, 0}, {0.5f, 0.5f, 0.5f, 0.5f});
  Image out;
  resolve({{3, 4}, kBack, 1, 2.2f}, samples, out);
  const auto red = static_cast<uint32_t>(std::lround(255 * std::pow(0.25, 1 / 2.2)));
  EXPECT_EQ(out.color[place(out, 1, 2)], 0x40000000u | red);
}

TEST(Resolve, AveragesOverRaysAreBlendedWithTheBackground) {
  Image average;
  average.resize(1, 1, 1, Image::kColorDepth | Plane::centerDepth);
  average.x = 1, average.y = 2;
  average.color = {0x80004080u};  // half covered, by the colour 0xFF0080FF
  average.depth = {0.25f}, average.centerDepth = {Image::kMiss};
  Image out;
  resolve({{3, 4}, 0xFF808000u, 1, 1}, average, out);
  const auto half = [](uint32_t above, uint32_t below) { return above + (below * 127 + 127) / 255; };
  EXPECT_EQ(out.color[place(out, 1, 2)],
            half(0x80, 0xFF) << 24 | half(0, 0x80) << 16 | half(0x40, 0x80) << 8 | half(0x80, 0));
  EXPECT_EQ(out.depth[place(out, 1, 2)], 1.0f);
  average.centerDepth = {0.25f};
  resolve({{3, 4}, 0xFF808000u, 1, 2.2f}, average, out);
  const double share = 128.0 / 255;
  EXPECT_NEAR(out.color[place(out, 1, 2)] & 255,
              255 * std::pow(share * std::pow(128 / share / 255, 2.2), 1 / 2.2), 1);
  EXPECT_EQ(out.depth[place(out, 1, 2)], 0.25f);
  EXPECT_EQ(out.color[place(out, 0, 0)], 0xFF808000u);
}

TEST(Resolve, HitsThatFailTheDepthTestAreBackground) {
  const Image samples = fourSamples({7, 7, 7, 7}, {1, 1, 1, 1});
  Image out;
  resolve({{3, 4}, kBack, std::nextafter(1.0f, 0.0f), 1}, samples, out);
  EXPECT_EQ(out.color[place(out, 1, 2)], kBack);
  resolve({{3, 4}, kBack, 1, 1}, samples, out);
  EXPECT_EQ(out.color[place(out, 1, 2)], 7u);
}

TEST(Resolve, ClipsImagesAtTheSize) {
  Image samples = fourSamples({7, 7, 7, 7}, {0, 0, 0, 0});
  Image out;
  for (const glm::ivec2 at : {glm::ivec2(-1, 0), glm::ivec2(0, -1), glm::ivec2(3, 0), glm::ivec2(0, 4)}) {
    samples.x = at.x, samples.y = at.y;
    resolve({{3, 4}, kBack, 1, 1}, samples, out);
    EXPECT_EQ(std::count(out.color.begin(), out.color.end(), kBack), 12) << at.x << " " << at.y;
  }
}

}  // namespace
}  // namespace gluray::render
