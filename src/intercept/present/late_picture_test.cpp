#include "intercept/present/late_picture.h"

#include <gtest/gtest.h>

namespace gluray::present {
namespace {

constexpr uint32_t kUnder = 0xff101010u, kTraced = 0xff0000ffu;

/// Two by one pixels at x = 1: one of that depth, a miss.
Image picture(float depth) {
  Image image;
  image.x = 1;
  image.resize(2, 1, 1);
  image.color = {kTraced, 0};
  image.depth = {depth, Image::kMiss};
  return image;
}

TEST(LatePicture, HitsCoverWhatIsBehindThem) {
  WindowContent content = plainWindow({4, 2}, kUnder, 0.5f);
  EXPECT_TRUE(merge(picture(0.25f), GL_LESS, content));
  EXPECT_EQ(content.colors,
            (std::vector<uint32_t>{kUnder, kTraced, kUnder, kUnder, kUnder, kUnder, kUnder, kUnder}));
}

TEST(LatePicture, TheDepthFunctionDecides) {
  for (const bool equal : {false, true}) {
    WindowContent content = plainWindow({4, 1}, kUnder, 0.5f);
    merge(picture(0.5f), equal ? GL_LEQUAL : GL_LESS, content);
    EXPECT_EQ(content.colors[1], equal ? kTraced : kUnder);
    merge(picture(0.75f), GL_LEQUAL, content);
    EXPECT_EQ(content.colors[1], equal ? kTraced : kUnder);
  }
}

TEST(LatePicture, WhatLiesOutsideIsCut) {
  Image image = picture(0.1f);
  image.x = -1, image.color[1] = kTraced, image.depth[1] = 0.1f;
  WindowContent content = plainWindow({2, 1}, kUnder, 1);
  EXPECT_TRUE(merge(image, GL_LESS, content));
  EXPECT_EQ(content.colors, (std::vector<uint32_t>{kTraced, kUnder}));
  image.y = 5;
  EXPECT_TRUE(merge(image, GL_LESS, content));
  EXPECT_EQ(content.colors, (std::vector<uint32_t>{kTraced, kUnder}));
}

TEST(LatePicture, AveragesAreBlended) {
  Image image = picture(0.1f);
  image.center = image.depth;
  image.color[0] = 0x80000080u;  // red, half of the pixel
  WindowContent content = plainWindow({4, 1}, 0xff0000ffu, 1);
  EXPECT_TRUE(merge(image, GL_LESS, content));
  EXPECT_EQ(content.colors[1], 0xff0000ffu);
}

TEST(LatePicture, PicturesOfOtherKindsAreLeftAlone) {
  WindowContent content = plainWindow({4, 1}, kUnder, 1);
  Image wide;
  wide.resize(2, 1, 1, Image::Content::wide);
  EXPECT_FALSE(merge(wide, GL_LESS, content));
  Image samples;
  samples.resize(2, 1, 4);
  EXPECT_FALSE(merge(samples, GL_LESS, content));
}

}  // namespace
}  // namespace gluray::present
