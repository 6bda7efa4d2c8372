#include "scene/replaced_pixels.h"

#include <gtest/gtest.h>

namespace gluray::scene {
namespace {

constexpr uint32_t kOld = 0xff102030u, kNew = 0xff405060u, kOther = 0xff0000ffu;

/// 4 x 3 pixels of one colour at depth 0.5; the left column misses.
Image imageOf(uint32_t color, int samples = 1) {
  Image image;
  image.x = 10, image.y = 20;
  image.resize(4, 3, samples);
  std::fill(image.color.begin(), image.color.end(), color);
  for (size_t i = 0; i < image.depth.size(); ++i) image.depth[i] = i % 4 == 0 ? Image::kMiss : 0.5f;
  return image;
}

ShownPixels shownOf(const Image& part, uint32_t color) {
  const size_t pixels = part.depth.size() / static_cast<size_t>(part.samples);
  return {std::vector<uint32_t>(pixels, color), std::vector<float>(pixels, 0.5f), 1e-6f};
}

TEST(ReplacedPixels, KeepsTheRectangleOfHits) {
  const Image part = writtenPart(imageOf(kOld));
  EXPECT_EQ(part.x, 11);
  EXPECT_EQ(part.y, 20);
  EXPECT_EQ(part.width, 3);
  EXPECT_EQ(part.height, 3);
  EXPECT_EQ(part.color, std::vector<uint32_t>(9, kOld));
}

TEST(ReplacedPixels, AnImageWithoutHitsHasNoPart) {
  Image image = imageOf(kOld);
  std::fill(image.depth.begin(), image.depth.end(), Image::kMiss);
  EXPECT_TRUE(writtenPart(image).color.empty());
}

TEST(ReplacedPixels, ReplacesWhatIsShownToTheBit) {
  const Image before = writtenPart(imageOf(kOld)), now = writtenPart(imageOf(kNew));
  ShownPixels shown = shownOf(before, kOld);
  shown.colors[4] = kOther;  // drawn over, without a depth
  shown.depths[5] = 0.4f;    // of equal colour, but nearer
  Image out;
  EXPECT_EQ(findReplaced(before, now, shown, out), 7u);
  for (size_t i = 0; i < out.depth.size(); ++i) {
    const bool kept = i == 4 || i == 5;
    EXPECT_EQ(out.depth[i], kept ? Image::kMiss : 0.5f) << i;
    EXPECT_TRUE(kept || out.color[i] == kNew) << i;
  }
}

TEST(ReplacedPixels, AlphaOfTheFramebufferDoesNotCount) {
  const Image before = writtenPart(imageOf(kOld)), now = writtenPart(imageOf(kNew));
  Image out;
  EXPECT_EQ(findReplaced(before, now, shownOf(before, kOld & 0xffffffu), out), 9u);
}

TEST(ReplacedPixels, AnotherShapeReplacesNothing) {
  const Image before = writtenPart(imageOf(kOld)), now = writtenPart(imageOf(kNew, 4));
  Image out;
  EXPECT_EQ(findReplaced(before, now, shownOf(before, kOld), out), 0u);
}

/// The mean of two samples of which one misses, over black: half of the colour.
TEST(ReplacedPixels, AveragesReplaceSinglesWithTheirWholeColor) {
  const Image before = writtenPart(imageOf(kOld));
  Image now = writtenPart(imageOf(kNew));
  now.planes = now.planes | Plane::centerDepth, now.centerDepth = now.depth;
  now.color[3] = 0x80202830u, now.color[4] = 0;
  Image out;
  EXPECT_EQ(findReplaced(before, now, shownOf(before, kOld), out), 9u);
  EXPECT_EQ(out.color[2], kNew);
  EXPECT_EQ(out.color[3], 0xff405060u);
  EXPECT_EQ(out.depth[4], Image::kMiss);
  EXPECT_EQ(findReplaced(now, before, shownOf(before, kOld), out), 0u) << "edges would lose their shape";
}

TEST(ReplacedPixels, EdgesFollowTheirNeighbours) {
  Image old = imageOf(kOld, 2), next = imageOf(kNew, 2);
  for (Image* image : {&old, &next}) image->depth[1] = Image::kMiss;  // the first pixel's first sample
  const Image before = writtenPart(old), now = writtenPart(next);
  ShownPixels shown{std::vector<uint32_t>(9, kOld), {}, 0};
  shown.colors[0] = 0xff081018u;
  Image out;
  EXPECT_EQ(findReplaced(before, now, shown, out), 9u);
  EXPECT_EQ(out.depth[0], Image::kMiss) << "the sample that missed";
  EXPECT_EQ(out.depth[9], 0.5f) << "the pixel's other sample";
  shown.colors[0] = 0xff000000u;  // cannot hold half of the colour
  EXPECT_EQ(findReplaced(before, now, shown, out), 8u);
  shown.colors.assign(9, kOther);
  shown.colors[0] = 0xff081018u;
  EXPECT_EQ(findReplaced(before, now, shown, out), 0u) << "no neighbour is shown";
}

/// Colours times coverage are blended over what is below: their exchange keeps its share.
TEST(ReplacedPixels, AveragesKeepTheirShareOfWhatIsBelow) {
  const auto averages = [](uint32_t whole, uint32_t edge) {
    Image image = imageOf(whole);
    image.resize(4, 3, 1, Image::kColorDepth | Plane::centerDepth);
    image.centerDepth = image.depth;
    image.color[1] = edge;
    return writtenPart(image);
  };
  const Image before = averages(kOld, 0x80081018u), now = averages(kNew, 0x80202830u);
  ShownPixels shown = shownOf(before, kOld);
  shown.colors[0] = 0xff481018u;  // the edge's share over blue
  Image out;
  EXPECT_EQ(findReplaced(before, now, shown, out), 9u);
  EXPECT_EQ(out.color[0], 0xff602830u);
  EXPECT_EQ(out.color[1], kNew);
}

/// One pixel at (12, 21) that covers half of what is below, in the colour (0x40, 0x20, 0).
std::shared_ptr<const Image> edgeAt(float depth, bool center) {
  Image edge;
  edge.x = 12, edge.y = 21;
  edge.resize(1, 1, 1, Image::kColorDepth | Plane::centerDepth);
  edge.color[0] = 0x80002040u, edge.depth[0] = depth, edge.centerDepth[0] = center ? depth : Image::kMiss;
  return std::make_shared<const Image>(edge);
}

TEST(ReplacedPixels, ShareOfWhatIsBelowLaterEdgesIsReplaced) {
  const Image before = writtenPart(imageOf(kOld)), now = writtenPart(imageOf(kNew));
  for (const bool center : {false, true}) {
    const std::vector<std::shared_ptr<const Image>> edges{edgeAt(0.4f, center)};
    ShownPixels shown = shownOf(before, kOld);
    shown.colors[4] = 0xff082f58u;  // the edge over half of the old colour
    if (center) shown.depths[4] = 0.4f;
    Image out;
    EXPECT_EQ(findReplaced(before, now, shown, out), 8u);
    EXPECT_EQ(findReplaced(before, now, shown, out, {edges}), 9u);
    EXPECT_EQ(out.color[4], 0xff204770u);
    EXPECT_EQ(out.depth[4], center ? 0.4f : 0.5f);
  }
}

TEST(ReplacedPixels, OtherColoursAndDepthsThanThoseOfLaterEdgesStay) {
  const Image before = writtenPart(imageOf(kOld)), now = writtenPart(imageOf(kNew));
  const std::vector<std::shared_ptr<const Image>> near{edgeAt(0.4f, false)}, behind{edgeAt(0.6f, false)};
  ShownPixels shown = shownOf(before, kOld);
  shown.colors[4] = 0xff0a2f58u;  // something else was drawn
  Image out;
  EXPECT_EQ(findReplaced(before, now, shown, out, {near}), 8u);
  shown.colors[4] = 0xff082f58u;
  EXPECT_EQ(findReplaced(before, now, shown, out, {behind}), 8u) << "the edge was not drawn";
  EXPECT_EQ(findReplaced(before, now, shown, out, {behind, true}), 9u) << "larger depths are nearer";
  shown.depths[4] = 0.3f;
  EXPECT_EQ(findReplaced(before, now, shown, out, {near}), 8u);
}

}  // namespace
}  // namespace gluray::scene
