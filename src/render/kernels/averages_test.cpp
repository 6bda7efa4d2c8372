// Pixels that average several samples (setting spp).
#include "base/log.h"
#include "render/testing/test_trace.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace gluray {
namespace {

using glm::vec3;

/// A half-plane of the window whose edge passes through (0, 0) at this angle, traced with `spp` samples.
Image halfPlane(float angle, int spp) {
  const vec3 along(std::cos(angle), std::sin(angle), 0), into(-along.y, along.x, 0);
  auto s = test::makeSnapshot({test::makeMesh(
      test::quadData(-4.0f * along, 4.0f * along, 4.0f * (along + into), 4.0f * (into - along)))});
  s.settings.spp = spp;
  return test::trace(s).image;
}

/// Coverage of pixel (x, y) of 16 x 16 by that half-plane, from 64 x 64 points.
float covered(float angle, int x, int y) {
  int inside = 0;
  for (int j = 0; j < 64; ++j) {
    for (int i = 0; i < 64; ++i) {
      const float u = (static_cast<float>(x) + (static_cast<float>(i) + 0.5f) / 64) / 8 - 1,
                  v = (static_cast<float>(y) + (static_cast<float>(j) + 0.5f) / 64) / 8 - 1;
      inside += -std::sin(angle) * u + std::cos(angle) * v > 0;
    }
  }
  return static_cast<float>(inside) / (64 * 64);
}

TEST(Averages, EqualTheCoverage) {
  for (const int spp : {4, 16, 64}) {
    const auto most = 1.5f / std::sqrt(static_cast<float>(spp)) * 255;
    double error = 0;
    for (const float angle : {0.1f, 0.7f, 1.3f, 2.9f}) {
      const Image image = halfPlane(angle, spp);
      for (int i = 0; i < 256; ++i) {
        const float expected = 255 * covered(angle, i % 16, i / 16);
        const auto got = static_cast<float>(image.color[static_cast<size_t>(i)] >> 24);
        ASSERT_NEAR(got, expected, most) << spp << " samples, angle " << angle << ", pixel " << i;
        ASSERT_EQ(image.color[static_cast<size_t>(i)] & 255, image.color[static_cast<size_t>(i)] >> 24);
        error += std::abs(got - expected);
      }
    }
    // Error of 255, over all pixels; with random samples it would only fall with the root of their number.
    EXPECT_LT(error / 1024, 10 / std::pow(spp, 0.75));
  }
}

TEST(Averages, DepthIsThatOfTheCentre) {
  const Image one = halfPlane(0.7f, 1), many = halfPlane(0.7f, 16);
  EXPECT_TRUE(one.centerDepth.empty());
  EXPECT_EQ(many.centerDepth, one.depth);
  size_t edge = 0;
  for (size_t i = 0; i < 256; ++i) {
    const bool seen = many.color[i] != 0;
    ASSERT_EQ(many.depth[i] != Image::kMiss, seen);
    edge += seen && many.centerDepth[i] == Image::kMiss;
  }
  EXPECT_GT(edge, 4u);
}

TEST(Averages, AreNotTakenInMultisampledFramebuffers) {
  auto s = test::makeSnapshot({test::makeMesh(test::squareData())});
  s.settings.spp = 16;
  s.samples = 2;
  s.samplePositions = {{0.25f, 0.25f}, {0.75f, 0.75f}};
  const Image image = test::trace(s).image;
  EXPECT_EQ(image.samples, 2);
  EXPECT_TRUE(image.centerDepth.empty());
}

TEST(Averages, ThatDoNotExistAreNotFilteredAndTheLogSaysSo) {
  const auto count = [](const char* text) {
    int lines = 0;
    for (const std::string& line : log::recent()) lines += line.find(text) != std::string::npos;
    return lines;
  };
  auto s = test::makeSnapshot({test::makeMesh(test::squareData())});
  s.settings.pixelFilter = PixelFilter::gauss;
  for (int i = 0; i < 2; ++i) test::trace(s);
  EXPECT_EQ(count("pixels have one sample each"), 1);
  s.settings.spp = 4;
  test::trace(s);
  EXPECT_EQ(count("pixel-filter has no effect"), 1);
  s.samples = 2;
  s.samplePositions = {{0.25f, 0.25f}, {0.75f, 0.75f}};
  test::trace(s);
  EXPECT_EQ(count("pixel-filter has no effect on images"), 1);
}

TEST(Averages, OneSampleIsTakenIfAlphaIsNoOpacity) {
  auto s = test::makeSnapshot({test::makeMesh(test::squareData())});
  s.settings.spp = 4;
  s.instances[0].color = {1, 0, 0, 0.5f};
  EXPECT_TRUE(test::trace(s).image.centerDepth.empty());
  s.instances[0].color.a = 1;
  EXPECT_FALSE(test::trace(s).image.centerDepth.empty());
}

TEST(Averages, OfLayersAndFloats) {
  auto s = test::makeSnapshot({test::makeMesh(test::squareData())});
  s.settings.spp = 4;
  s.instances[0].color = {1, 0, 0, 0.5f};
  auto layers = std::make_shared<scene::Layers>();
  layers->opaqueDepth.assign(256, -1);
  s.layers = layers;
  Image image = test::trace(s).image;
  EXPECT_EQ(image.color, std::vector<uint32_t>(256, 0x80000080u));
  layers = std::make_shared<scene::Layers>(*layers);
  layers->of = scene::Layers::Of::sums;
  s.layers = layers;
  image = test::trace(s).image;
  for (size_t i = 0; i < 256; ++i) ASSERT_FLOAT_EQ(image.transmittance[i], 0.5f);
  s.layers = nullptr;
  s.wideColors = true;
  s.instances[0].color.a = 1;
  image = test::trace(s).image;
  for (size_t i = 0; i < 256; ++i) ASSERT_FLOAT_EQ(image.wideColor[4 * i], 1);
}

}  // namespace
}  // namespace gluray
