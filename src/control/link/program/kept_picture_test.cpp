#include "control/link/program/kept_picture.h"

#include <gtest/gtest.h>

namespace gluray::control {
namespace {

constexpr uint32_t kRed = 0xff0000ff, kBlue = 0xffff0000, kWhite = 0xffffffff, kBlack = 0xff000000;

KeptPicture plain(int width, int height) {
  return {width, height, KeptPicture::Layout::openGl,
          std::vector<uint32_t>(static_cast<size_t>(width) * static_cast<size_t>(height), kWhite)};
}

TEST(KeptPicture, RowsAreSentFromTheTop) {
  const KeptPicture openGl{2, 2, KeptPicture::Layout::openGl, {kRed, kBlue, kWhite, kBlack}};
  EXPECT_EQ(rgbOf(openGl).bytes, std::string("\xff\xff\xff\0\0\0\xff\0\0\0\0\xff", 12));
  const KeptPicture x{2, 2, KeptPicture::Layout::x, {kRed, kBlue, kWhite, kBlack}};  // blue, red
  EXPECT_EQ(rgbOf(x).bytes, std::string("\0\0\xff\xff\0\0\xff\xff\xff\0\0\0", 12));
}

TEST(KeptPicture, PixelsAreAverages) {
  const KeptPicture picture{
      4, 2, KeptPicture::Layout::openGl, {kBlack, kWhite, kRed, kRed, kBlack, kBlack, kRed, kBlue}};
  const RgbPicture small = scaledDown(picture, 2, 1000);
  EXPECT_EQ(small.width, 2);
  EXPECT_EQ(small.height, 1);
  EXPECT_EQ(small.bytes, std::string("\x40\x40\x40\xbf\0\x40", 6));  // 63.75; 191.25, 0, 63.75
}

TEST(KeptPicture, SizesThatDoNotDivideAreCoveredWhole) {
  KeptPicture picture = plain(7, 5);
  const RgbPicture small = scaledDown(picture, 3, 1000);
  EXPECT_EQ(small.width, 3);
  EXPECT_EQ(small.height, 2);
  EXPECT_EQ(small.bytes, std::string(18, '\xff'));
  picture.pixels[34] = kBlack;  // the last of the top row
  EXPECT_EQ(static_cast<unsigned char>(scaledDown(picture, 3, 1000).bytes[6]), 213);  // 255 * 5 / 6
}

TEST(KeptPicture, Limits) {
  const auto sizeOf = [](int width, int height, int longest, int64_t most) {
    const RgbPicture picture = scaledDown(plain(width, height), longest, most);
    EXPECT_EQ(picture.bytes.size(), 3u * static_cast<size_t>(picture.width * picture.height));
    return std::pair(picture.width, picture.height);
  };
  EXPECT_EQ(sizeOf(640, 480, 256, 1 << 20), std::pair(256, 192));
  EXPECT_EQ(sizeOf(480, 640, 256, 1 << 20), std::pair(192, 256));
  EXPECT_EQ(sizeOf(100, 50, 256, 1 << 20), std::pair(100, 50)) << "never larger";
  EXPECT_EQ(sizeOf(3000, 2, 256, 1 << 20), std::pair(256, 1)) << "at least a pixel";
  EXPECT_EQ(sizeOf(600, 600, 512, 10000), std::pair(100, 100));
  EXPECT_EQ(sizeOf(1, 1, 16, 100), std::pair(1, 1));
}

TEST(KeptPicture, WhatIsNotWholeIsEmpty) {
  EXPECT_EQ(rgbOf({}).bytes, "");
  EXPECT_EQ(rgbOf({2, 2, KeptPicture::Layout::x, {kRed}}).width, 0);
  EXPECT_EQ(scaledDown({-1, 2, KeptPicture::Layout::x, {}}, 9, 9).bytes, "");
}

}  // namespace
}  // namespace gluray::control
