#include "intercept/windows/shm_window.h"

#include <gtest/gtest.h>

#include <vector>

namespace gluray::intercept {
namespace {

constexpr uint32_t kMissColor = 0xff102030, kMissShown = 0xff302010;

/// Three by two pixels, one of them a miss and one beyond the farthest depth.
Image makeImage(int x, int y) {
  Image image;
  image.missColor = kMissColor;
  image.x = x, image.y = y;
  image.resize(3, 2, 1);
  image.color = {0x01020304, 0x11121314, kMissColor, 0x31323334, 0x41424344, 0x51525354};
  image.depth = {0, 0.5f, Image::kMiss, 1, 0.999f, 0.25f};
  return image;
}

std::vector<uint32_t> shown(const Image& image, glm::ivec2 size, float farthest = 1) {
  std::vector<uint32_t> pixels(static_cast<size_t>(size.x * size.y), 0xdeadbeef);
  fillWindow({image, farthest, 1}, size, pixels.data());
  return pixels;
}

TEST(ShmWindow, RowsComeFromTheTopWithBlueFirst) {
  EXPECT_EQ(shown(makeImage(0, 0), {3, 2}),
            (std::vector<uint32_t>{0x31343332, 0x41444342, 0x51545352, 0x01040302, 0x11141312, kMissShown}));
}

TEST(ShmWindow, HitsBeyondTheFarthestAreMisses) {
  EXPECT_EQ(shown(makeImage(0, 0), {3, 2}, 0.9995f)[0], kMissShown);
  EXPECT_EQ(shown(makeImage(0, 0), {3, 2}, 0.9995f)[1], 0x41444342u);
}

TEST(ShmWindow, TheRestOfTheWindowHasTheMissColour) {
  const std::vector<uint32_t> pixels = shown(makeImage(1, 1), {5, 4});
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 5; ++x) {
      const bool inside = x >= 1 && x < 4 && y >= 1 && y < 3;  // rows from the top: 1 and 2 either way
      if (!inside) { EXPECT_EQ(pixels[static_cast<size_t>(y * 5 + x)], kMissShown) << x << ' ' << y; }
    }
  EXPECT_EQ(pixels[6], 0x31343332u);
  EXPECT_EQ(pixels[11], 0x01040302u);
}

TEST(ShmWindow, ImagesMayReachBeyondTheWindow) {
  EXPECT_EQ(shown(makeImage(-1, -1), {2, 1}), (std::vector<uint32_t>{0x41444342, 0x51545352}));
  EXPECT_EQ(shown(makeImage(1, 0), {2, 2}),
            (std::vector<uint32_t>{kMissShown, 0x31343332, kMissShown, 0x01040302}));
  EXPECT_EQ(shown(makeImage(7, 0), {2, 1}), (std::vector<uint32_t>{kMissShown, kMissShown}));
  EXPECT_EQ(shown(makeImage(-7, 0), {2, 1}), (std::vector<uint32_t>{kMissShown, kMissShown}));
}

}  // namespace
}  // namespace gluray::intercept
