#include "control/link/program/kept_image.h"

#include <gtest/gtest.h>

namespace gluray::control {
namespace {

constexpr uint32_t kRed = 0xff0000ff, kBlue = 0xffff0000, kWhite = 0xffffffff, kBlack = 0xff000000;

KeptImage plain(int width, int height) {
  return {width, height, KeptImage::Layout::openGl,
          std::vector<uint32_t>(static_cast<size_t>(width) * static_cast<size_t>(height), kWhite)};
}

TEST(KeptImage, RowsAreSentFromTheTop) {
  const KeptImage openGl{2, 2, KeptImage::Layout::openGl, {kRed, kBlue, kWhite, kBlack}};
  EXPECT_EQ(rgbOf(openGl).bytes, std::string("\xff\xff\xff\0\0\0\xff\0\0\0\0\xff", 12));
  const KeptImage x{2, 2, KeptImage::Layout::x, {kRed, kBlue, kWhite, kBlack}};  // blue, red
  EXPECT_EQ(rgbOf(x).bytes, std::string("\0\0\xff\xff\0\0\xff\xff\xff\0\0\0", 12));
}

TEST(KeptImage, PixelsAreAverages) {
  const KeptImage image{
      4, 2, KeptImage::Layout::openGl, {kBlack, kWhite, kRed, kRed, kBlack, kBlack, kRed, kBlue}};
  const RgbImage small = scaledDown(image, 2, 1000);
  EXPECT_EQ(small.width, 2);
  EXPECT_EQ(small.height, 1);
  EXPECT_EQ(small.bytes, std::string("\x40\x40\x40\xbf\0\x40", 6));  // 63.75; 191.25, 0, 63.75
}

TEST(KeptImage, SizesThatDoNotDivideAreCoveredWhole) {
  KeptImage image = plain(7, 5);
  const RgbImage small = scaledDown(image, 3, 1000);
  EXPECT_EQ(small.width, 3);
  EXPECT_EQ(small.height, 2);
  EXPECT_EQ(small.bytes, std::string(18, '\xff'));
  image.pixels[34] = kBlack;                                                        // the last of the top row
  EXPECT_EQ(static_cast<unsigned char>(scaledDown(image, 3, 1000).bytes[6]), 213);  // 255 * 5 / 6
}

TEST(KeptImage, Limits) {
  const auto sizeOf = [](int width, int height, int longest, int64_t most) {
    const RgbImage image = scaledDown(plain(width, height), longest, most);
    EXPECT_EQ(image.bytes.size(), 3u * static_cast<size_t>(image.width * image.height));
    return std::pair(image.width, image.height);
  };
  EXPECT_EQ(sizeOf(640, 480, 256, 1 << 20), std::pair(256, 192));
  EXPECT_EQ(sizeOf(480, 640, 256, 1 << 20), std::pair(192, 256));
  EXPECT_EQ(sizeOf(100, 50, 256, 1 << 20), std::pair(100, 50)) << "never larger";
  EXPECT_EQ(sizeOf(3000, 2, 256, 1 << 20), std::pair(256, 1)) << "at least a pixel";
  EXPECT_EQ(sizeOf(600, 600, 512, 10000), std::pair(100, 100));
  EXPECT_EQ(sizeOf(1, 1, 16, 100), std::pair(1, 1));
}

TEST(KeptImage, WhatIsNotWholeIsEmpty) {
  EXPECT_EQ(rgbOf({}).bytes, "");
  EXPECT_EQ(rgbOf({2, 2, KeptImage::Layout::x, {kRed}}).width, 0);
  EXPECT_EQ(scaledDown({-1, 2, KeptImage::Layout::x, {}}, 9, 9).bytes, "");
}

}  // namespace
}  // namespace gluray::control
