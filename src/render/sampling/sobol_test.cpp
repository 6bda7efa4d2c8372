// Points of pixels: those of one pixel are stratified, and so are those of neighbouring pixels together.
#include "render/sampling/sobol.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>
#include <vector>

namespace gluray::render {
namespace {

constexpr uint32_t kUse = static_cast<uint32_t>(Dimensions::ambientOcclusion);

/// Seeds of the pixels of a 4x4 block, row by row.
PixelSeeds seedsAt(int column, int row) {
  float x[kLanes], y[kLanes];
  for (int i = 0; i < kLanes; ++i) {
    x[i] = static_cast<float>(column + i % 4) + 0.5f, y[i] = static_cast<float>(row + i / 4 % 4) + 0.5f;
  }
  return blockSeeds(x, y);
}

/// Whether each elementary interval of the unit square has one of the 2^m points, before scrambling, which
/// keeps that. `points`: numbers in the sequence.
bool isNet(const std::vector<uint32_t>& points, int m) {
  for (int across = 0; across <= m; ++across) {
    std::set<std::pair<uint32_t, uint32_t>> intervals;
    for (const uint32_t p : points)  // digits are in reversed order
      intervals.emplace(p & ((1u << across) - 1), reversedSobol(p) & ((1u << (m - across)) - 1));
    if (intervals.size() != points.size()) return false;
  }
  return points.size() == size_t{1} << m;
}

TEST(Sobol, PointsOfAPixelAreASequenceOfNets) {
  const PixelSeeds seeds = seedsAt(0, 0);
  for (const uint32_t use : {kUse, 2u, 1024u, 1025u})
    for (int pixel = 0; pixel < 16; ++pixel)
      for (int m = 0; m <= 9; ++m) {
        std::vector<uint32_t> points;
        for (uint32_t i = 0; i < 1u << m; ++i) points.push_back(turnedBlock(i, use) ^ seeds.first[pixel]);
        EXPECT_TRUE(isNet(points, m)) << use << ' ' << pixel << ' ' << m;
      }
}

TEST(Sobol, PointsOfNeighboursAreANet) {
  const PixelSeeds seeds = seedsAt(8, 4);
  for (uint32_t i = 0; i < 64; ++i) {
    std::vector<uint32_t> block, quad;
    for (int pixel = 0; pixel < 16; ++pixel) {
      block.push_back(turnedBlock(i, kUse) ^ seeds.first[pixel]);
      if (pixel % 4 < 2 && pixel / 4 < 2) quad.push_back(block.back());
      EXPECT_EQ(seeds.seed[pixel], seeds.seed[0]);
    }
    EXPECT_TRUE(isNet(block, 4)) << i;
    EXPECT_TRUE(isNet(quad, 2)) << i;
  }
  EXPECT_NE(seedsAt(12, 4).seed[0], seeds.seed[0]);
}

}  // namespace
}  // namespace gluray::render
