// Packed depths hide what lies behind them, and nothing else.
#include "cluster/peers/tile_depths.h"

#include "cluster/stream/byte_stream.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace gluray::cluster {
namespace {

using render::DrawnPart;
using render::HiddenPixels;
using render::Tile;

constexpr Tile kTile{32, 0, 64, 20};  // not whole
constexpr float kDepthStep = 0x1p-22f;

using Depth = std::function<float(int x, int y)>;

Image imageOf(const Depth& depth) {
  Image image;
  image.resize(70, 20, 1);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) image.depth[static_cast<size_t>(y * image.width + x)] = depth(x, y);
  return image;
}

DrawnPart part(float nearest, float farthest) {
  DrawnPart part;
  part.region = {0, 0, 70, 20}, part.tiles = {0, 0, 3, 1};
  part.nearest = nearest, part.farthest = farthest;
  return part;
}

bool isHidden(const HiddenPixels& hidden, int x, int y) {
  return hidden.rows[static_cast<size_t>(y - kTile.y0)] >> (x - kTile.x0) & 1;
}

HiddenPixels hiddenBy(const Depth& front, const Depth& own, const DrawnPart& range,
                      bool largestWins = false) {
  HiddenPixels hidden;
  addHidden(packDepths(imageOf(front), kTile, range, largestWins), range, imageOf(own), kTile, largestWins,
            kDepthStep, hidden);
  return hidden;
}

TEST(TileDepths, WhatIsBehindIsHidden) {
  const auto front = [](int x, int y) {
    return 0.4f + 0.001f * static_cast<float>(x) - 0.0005f * static_cast<float>(y);
  };
  const auto behind = [&](int x, int y) { return front(x, y) + 0.001f; };
  const HiddenPixels hidden = hiddenBy(front, behind, part(0.3f, 0.6f));
  for (int y = kTile.y0; y < kTile.y1; ++y)
    for (int x = kTile.x0; x < kTile.x1; ++x) EXPECT_TRUE(isHidden(hidden, x, y)) << x << " " << y;
  for (size_t row = 20; row < 32; ++row) EXPECT_EQ(hidden.rows[row], 0u) << "below the image's edge";
}

TEST(TileDepths, NothingIsHiddenByWhatIsEquallyFarAwayOrBehind) {
  const auto front = [](int x, int y) { return 0.5f + 0.01f * std::sin(static_cast<float>(x * y)); };
  EXPECT_EQ(hiddenBy(front, front, part(0.3f, 0.6f)).rows, HiddenPixels{}.rows);
  const auto nearer = [&](int x, int y) { return front(x, y) - 1e-6f; };
  EXPECT_EQ(hiddenBy(front, nearer, part(0.3f, 0.6f)).rows, HiddenPixels{}.rows);
}

TEST(TileDepths, MissesHideNothingAndAreNotHidden) {
  const auto half = [](int x, int) { return x % 2 ? Image::kMiss : 0.25f; };
  const auto own = [](int, int y) { return y % 2 ? Image::kMiss : 0.5f; };
  const HiddenPixels hidden = hiddenBy(half, own, part(0.2f, 0.3f));
  for (int y = kTile.y0; y < kTile.y1; ++y)
    for (int x = kTile.x0; x < kTile.x1; ++x) EXPECT_EQ(isHidden(hidden, x, y), x % 2 == 0 && y % 2 == 0);
}

TEST(TileDepths, TheLargestDepthMayWin) {
  const auto front = [](int, int) { return 0.7f; };
  const auto own = [](int x, int) { return x % 2 ? 0.6f : 0.8f; };
  const HiddenPixels hidden = hiddenBy(front, own, part(0.2f, 0.5f), true);
  for (int x = kTile.x0; x < kTile.x1; ++x) EXPECT_EQ(isHidden(hidden, x, 3), x % 2 == 1);
}

/// Random depths, also beyond the part's bounds, which rounding may cause.
TEST(TileDepths, NeverHideWhatIsInFront) {
  std::mt19937 random(3);
  for (int round = 0; round < 200; ++round) {
    std::uniform_real_distribution<float> any(0, 1);
    const float a = any(random), b = any(random);
    const DrawnPart range = part(std::min(a, b), round % 10 ? std::max(a, b) : std::min(a, b));
    const auto noise = [&](int, int) { return any(random) < 0.2f ? Image::kMiss : any(random); };
    const Image front = imageOf(noise), own = imageOf(noise);
    HiddenPixels hidden;
    addHidden(packDepths(front, kTile, range, false), range, own, kTile, false, kDepthStep, hidden);
    const float unsure = (range.farthest - range.nearest) / 65000 + 2 * kDepthStep;
    for (int y = kTile.y0; y < kTile.y1; ++y) {
      for (int x = kTile.x0; x < kTile.x1; ++x) {
        const auto at = static_cast<size_t>(y * own.width + x);
        const bool miss = front.depth[at] == Image::kMiss || own.depth[at] == Image::kMiss;
        if (miss || front.depth[at] >= own.depth[at]) {
          EXPECT_FALSE(isHidden(hidden, x, y)) << round;
        } else if (front.depth[at] <= range.farthest &&
                   std::max(front.depth[at], range.nearest) + unsure < own.depth[at]) {
          EXPECT_TRUE(isHidden(hidden, x, y)) << round;
        }
      }
    }
  }
}

TEST(TileDepths, AreSmall) {
  const auto empty = [](int, int) { return Image::kMiss; };
  EXPECT_TRUE(packDepths(imageOf(empty), kTile, part(0, 1), false).empty());
  const auto plane = [](int x, int y) {
    return 0.3f + 1e-4f * static_cast<float>(x) + 2e-4f * static_cast<float>(y);
  };
  EXPECT_LT(packDepths(imageOf(plane), kTile, part(0.2f, 0.4f), false).size(), 20 * 36u);
}

TEST(TileDepths, RefusesOtherBytes) {
  const Image own = imageOf([](int, int) { return 0.5f; });
  std::vector<std::byte> packed = packDepths(own, kTile, part(0, 1), false);
  std::mt19937 random(5);
  int refused = 0;
  for (int i = 0; i < 500; ++i) {
    std::vector<std::byte> other = packed;
    other[random() % other.size()] = static_cast<std::byte>(random());
    other.resize(random() % 3 ? other.size() : random() % other.size() + 1);
    HiddenPixels hidden;
    try {
      addHidden(other, part(0, 1), own, kTile, false, kDepthStep, hidden);
    } catch (const Malformed&) { ++refused; }
  }
  EXPECT_GT(refused, 50);
  packed.push_back(std::byte{});
  packed.insert(packed.end(), 40, std::byte{0});
  HiddenPixels hidden;
  EXPECT_THROW(addHidden(packed, part(0, 1), own, kTile, false, kDepthStep, hidden), Malformed);
}

}  // namespace
}  // namespace gluray::cluster
