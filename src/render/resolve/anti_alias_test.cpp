// Anti-aliasing of finished images: known answers, and equal results of every instruction set.
#include "render/resolve/anti_alias.h"

#include "render/testing/reference_fxaa.h"
#include "render/testing/test_targets.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <random>
#include <vector>

namespace gluray::render {
namespace {

constexpr int kWidth = 67, kHeight = 41;  // not multiples of vector lengths

uint32_t grey(int v) {
  const auto c = static_cast<uint32_t>(v);
  return c | c << 8 | c << 16 | 0x80000000u;
}
int redOf(uint32_t pixel) { return static_cast<int>(pixel & 255); }

using Shape = std::function<uint32_t(int x, int y)>;

std::vector<uint32_t> paint(const Shape& shape) {
  std::vector<uint32_t> image;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) image.push_back(shape(x, y));
  return image;
}

std::vector<uint32_t> antialiased(const std::vector<uint32_t>& in, const scene::Fxaa& settings = {}) {
  std::vector<uint32_t> out(in.size());
  FxaaMemory memory;
  fxaa(settings, in.data(), kWidth, kHeight, out.data(), memory);
  return out;
}

const uint32_t& at(const std::vector<uint32_t>& image, int x, int y) {
  return image[static_cast<size_t>(y * kWidth + x)];
}

TEST(Fxaa, UniformImagesAreUnchanged) {
  const auto image = paint([](int, int) { return grey(90); });
  EXPECT_EQ(antialiased(image), image);
}

TEST(Fxaa, GentleSlopesAreUnchanged) {
  const auto image = paint([](int x, int y) { return grey(100 + x + y); });
  EXPECT_EQ(antialiased(image), image);
}

// A straight edge has no end within reach, so its slope is unknown.
TEST(Fxaa, StraightEdgesAreUnchanged) {
  const auto upright = paint([](int x, int) { return grey(x < 30 ? 20 : 220); });
  EXPECT_EQ(antialiased(upright), upright);
  const auto level = paint([](int, int y) { return grey(y < 20 ? 20 : 220); });
  EXPECT_EQ(antialiased(level), level);
}

// On a staircase each pixel is blended by its distance from the step's end, by VTK's formula. Steps are ten
// pixels long; the pixel beside the end on the bright side is 1 from one end and 10 from the other: offset
// 0.5 - 1/11.
TEST(Fxaa, StairsAreBlendedTowardsTheirEnds) {
  scene::Fxaa settings;
  settings.subpixelContrast = 0.99f;  // edges only
  const auto stair = paint([](int x, int y) { return grey(y < 10 + x / 10 ? 0 : 200); });
  const auto out = antialiased(stair, settings);
  const int x = 20, y = 11;  // the first pixel of a step, just under it: dark above, bright at its left
  ASSERT_EQ(redOf(at(stair, x, y)), 0);
  const double offset = 0.5 - 1.0 / 11.0;
  EXPECT_NEAR(redOf(at(out, x, y)), 200 * offset, 1);
  EXPECT_EQ(redOf(at(out, x + 9, y)), 0);  // at the far end the bright step's pixels are blended
  EXPECT_EQ(at(out, x, y) >> 24, 0x80u);   // alpha is unchanged
}

TEST(Fxaa, SinglePixelsFade) {
  const auto dot = paint([](int x, int y) { return grey(x == 33 && y == 20 ? 255 : 0); });
  const int centre = redOf(at(antialiased(dot), 33, 20));
  EXPECT_LT(centre, 160);
  EXPECT_GT(centre, 0);
}

// The vectorised and the scalar path agree in every column.
TEST(Fxaa, EveryColumnIsTreatedAlike) {
  const auto bars = [](int shift) {
    return paint([=](int x, int y) { return grey((x + shift) % 13 == 0 && y % 7 < 3 ? 240 : 30); });
  };
  const auto base = antialiased(bars(0));
  for (int shift = 1; shift < 13; ++shift) {
    const auto moved = antialiased(bars(shift));
    for (int y = 0; y < kHeight; ++y)
      for (int x = 14; x + 14 + shift < kWidth; ++x)
        ASSERT_EQ(at(moved, x, y), at(base, x + shift, y)) << shift << " at " << x << ", " << y;
  }
}

TEST(Fxaa, BordersRepeat) {
  const auto image = paint([](int x, int y) { return grey((x * 7 + y * 13) % 5 == 0 ? 250 : 10); });
  for (const auto& [w, h] : {std::pair{1, 1}, {1, 9}, {9, 1}, {2, 2}}) {
    std::vector<uint32_t> out(static_cast<size_t>(w * h));
    FxaaMemory memory;
    fxaa({}, image.data(), w, h, out.data(), memory);
    for (const uint32_t pixel : out) EXPECT_LE(redOf(pixel), 250);
  }
}

// Slanted edges, dots, stairs and noise of few values (with many equal distances and contrasts), on images
// narrower and wider than vectors and than the part that is filtered at once.
std::vector<uint32_t> scribble(int width, int height, uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<uint32_t> image;
  const double slope = static_cast<double>(random() % 400) / 100 - 2;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const bool side = y * slope + x > 0.4 * width, dot = random() % 29 == 0, noisy = x > 0.7 * width;
      const uint32_t base = side ? 0x80C8B478u : 0x401E3C0Au;
      const uint32_t some = (random() % 4) * 0x00401020u;
      image.push_back(noisy ? 0xFF000000u + some : dot ? base ^ 0x00FFFFFFu : base);
    }
  return image;
}

void expectAsReference(int width, int height, const scene::Fxaa& settings, uint32_t seed) {
  const auto image = scribble(width, height, seed);
  const ReferenceFxaa reference(settings, image.data(), width, height);
  std::vector<uint32_t> out(image.size());
  FxaaMemory memory;
  fxaa(settings, image.data(), width, height, out.data(), memory);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      ASSERT_EQ(out[static_cast<size_t>(y * width + x)], reference.at(x, y))
          << width << "x" << height << " at " << x << ", " << y;
}

TEST(Fxaa, EveryInstructionSetMatchesTheProgram) {
  scene::Fxaa edges, few, none;
  edges.subpixelContrast = 0.99f;
  few.endpointSearchIterations = 3;
  none.endpointSearchIterations = 0;
  test::withEachTarget([&](int64_t target) {
    SCOPED_TRACE(hwy::TargetName(target));
    uint32_t seed = 1;
    for (const auto& [width, height] : {std::pair{1, 1}, {2, 3}, {15, 4}, {17, 40}, {67, 41}, {700, 30}})
      for (const scene::Fxaa& settings : {scene::Fxaa{}, edges, few, none})
        expectAsReference(width, height, settings, seed++);
  });
}

}  // namespace
}  // namespace gluray::render
