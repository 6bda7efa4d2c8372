// Images of noise: known colours, and more where more is.
#include "frame/refinement/noise_image.h"

#include "frame/testing/lit_scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gluray::frame {
namespace {

Image surfaces(int width) {
  Image image;
  image.resize(width, 1, 1);
  image.color.assign(static_cast<size_t>(width), 0x80112233u),
      image.depth.assign(static_cast<size_t>(width), 0.5f);
  return image;
}

uint16_t code(float noise) { return static_cast<uint16_t>(std::lround(noise * 65535)); }

TEST(NoiseImage, HasTheColoursThatItsSettingNames) {
  const auto colorFor = [](float noise) {
    Image image = surfaces(3);
    paintNoise({code(noise), code(noise), code(noise)}, 0.01f, image);
    return image.color[1];
  };
  EXPECT_EQ(colorFor(0), 0x80000000u);
  EXPECT_NEAR(colorFor(0.005f) & 255, 128, 2);
  EXPECT_NEAR(colorFor(0.01f) & 255, 255, 2);
  EXPECT_NEAR(colorFor(0.02f) >> 8 & 255, 255, 2);
  EXPECT_NEAR(colorFor(0.02f) >> 16 & 255, 0, 2);
  EXPECT_EQ(colorFor(0.05f), 0x80ffffffu);
}

TEST(NoiseImage, KeepsTheBackgroundAndShowsTheUnknownAsWhite) {
  Image image = surfaces(2);
  image.depth[1] = Image::kMiss;
  paintNoise({}, 0.01f, image);
  EXPECT_EQ(image.color[0], 0x80ffffffu);
  EXPECT_EQ(image.color[1], 0x80112233u);
  paintNoNoise(image);
  EXPECT_EQ(image.color[0], 0x80000000u);
  EXPECT_EQ(image.color[1], 0x80112233u);
}

double meanRed(int passes) {
  scene::Snapshot s = test::litScene();
  s.settings.look = Look::noise, s.settings.noise = 0.2f, s.settings.refine.adaptive = false;
  Refinement refinement;
  test::CountingTrace tracer;
  Refiner refiner(s, refinement);
  scene::TraceCost cost;
  std::string error;
  for (int i = 0; i < passes; ++i) EXPECT_TRUE(refiner.pass(tracer.trace, 0, cost, error));
  Image image;
  refiner.show(image);
  double sum = 0;
  for (const uint32_t color : image.color) sum += color & 255;
  return sum / static_cast<double>(image.color.size());
}

TEST(NoiseImage, DarkensWithMorePasses) {
  const double few = meanRed(4), more = meanRed(16), many = meanRed(64);
  EXPECT_EQ(meanRed(1), 255) << "not known";
  EXPECT_LT(more, 0.7 * few);
  EXPECT_LT(many, 0.7 * more);
  EXPECT_GT(many, 0);
}

}  // namespace
}  // namespace gluray::frame
