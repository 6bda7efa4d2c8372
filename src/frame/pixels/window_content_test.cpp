#include "frame/pixels/window_content.h"

#include <gtest/gtest.h>

namespace gluray::frame {
namespace {

constexpr uint32_t kUnder = 0xff101010u, kTraced = 0xff0000ffu;

/// 2x1 pixels at x = 1: a hit at `depth`, and a miss.
Image makeImage(float depth) {
  Image image;
  image.x = 1;
  image.resize(2, 1, 1);
  image.color = {kTraced, 0};
  image.depth = {depth, Image::kMiss};
  return image;
}

TEST(WindowContent, HitsHideFartherPixels) {
  WindowContent content = plainWindow({4, 2}, kUnder, 0.5f);
  EXPECT_TRUE(merge(makeImage(0.25f), DepthTest::less, content));
  EXPECT_EQ(content.colors,
            (std::vector<uint32_t>{kUnder, kTraced, kUnder, kUnder, kUnder, kUnder, kUnder, kUnder}));
}

TEST(WindowContent, FollowsTheDepthFunction) {
  for (const bool equal : {false, true}) {
    WindowContent content = plainWindow({4, 1}, kUnder, 0.5f);
    merge(makeImage(0.5f), equal ? DepthTest::lessOrEqual : DepthTest::less, content);
    EXPECT_EQ(content.colors[1], equal ? kTraced : kUnder);
    merge(makeImage(0.75f), DepthTest::lessOrEqual, content);
    EXPECT_EQ(content.colors[1], equal ? kTraced : kUnder);
  }
}

TEST(WindowContent, ClipsAtTheWindow) {
  Image image = makeImage(0.1f);
  image.x = -1, image.color[1] = kTraced, image.depth[1] = 0.1f;
  WindowContent content = plainWindow({2, 1}, kUnder, 1);
  EXPECT_TRUE(merge(image, DepthTest::less, content));
  EXPECT_EQ(content.colors, (std::vector<uint32_t>{kTraced, kUnder}));
  image.y = 5;
  EXPECT_TRUE(merge(image, DepthTest::less, content));
  EXPECT_EQ(content.colors, (std::vector<uint32_t>{kTraced, kUnder}));
}

TEST(WindowContent, AveragesAreBlended) {
  Image image = makeImage(0.1f);
  image.planes = image.planes | Plane::centerDepth;
  image.centerDepth = image.depth;
  image.color[0] = 0x80000080u;  // red over half of the pixel
  WindowContent content = plainWindow({4, 1}, 0xff0000ffu, 1);
  EXPECT_TRUE(merge(image, DepthTest::less, content));
  EXPECT_EQ(content.colors[1], 0xff0000ffu);
}

TEST(WindowContent, RefusesOtherPlanes) {
  WindowContent content = plainWindow({4, 1}, kUnder, 1);
  Image wide;
  wide.resize(2, 1, 1, Image::kWide);
  EXPECT_FALSE(merge(wide, DepthTest::less, content));
  Image samples;
  samples.resize(2, 1, 4);
  EXPECT_FALSE(merge(samples, DepthTest::less, content));
}

}  // namespace
}  // namespace gluray::frame
