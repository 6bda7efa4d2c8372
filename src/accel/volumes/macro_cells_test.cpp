// Macro cells bound what linear filters return.
#include "accel/volumes/macro_cells.h"

#include "accel/testing/test_grids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace gluray::accel {
namespace {

constexpr int kSide = MacroCells::kSide;

size_t macroCellIndex(const MacroCells& cells, const glm::ivec3& cell) {
  return static_cast<size_t>((cell.z * cells.size().y + cell.y) * cells.size().x + cell.x);
}

/// The range of cell (i, j, k) by its definition.
void expectRange(const scene::VoxelGrid& grid, int channel, const MacroCells& cells, const glm::ivec3& cell) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  const glm::ivec3 first = cell * kSide, end = glm::min(first + kSide + 1, grid.size);
  test::eachVoxel(end - first, [&](const glm::ivec3& voxel) {
    const double value = test::valueOf(grid, first + voxel, channel);
    least = std::min(least, value), most = std::max(most, value);
  });
  const MacroCells::Range& range = cells.ranges()[macroCellIndex(cells, cell)];
  EXPECT_EQ(range.least, static_cast<float>(least));
  EXPECT_EQ(range.most, static_cast<float>(most));
}

/// Samples everywhere lie within the ranges of their cells.
void expectBounds(const scene::VoxelGrid& grid, int channel, const MacroCells& cells, test::Random& random) {
  constexpr double kRounding = 1e-6;
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 at = random.point(-0.1, 1.1);
    const glm::dvec3 u =
        glm::clamp(at * glm::dvec3(grid.size) - 0.5, glm::dvec3(0), glm::dvec3(grid.size - 1));
    const glm::ivec3 cell = glm::min(glm::ivec3(u) / kSide, cells.size() - 1);
    const MacroCells::Range& range = cells.ranges()[macroCellIndex(cells, cell)];
    const double value = test::linearAt(grid, at, channel);
    EXPECT_GE(value, range.least - kRounding);
    EXPECT_LE(value, range.most + kRounding);
  }
}

void expectCells(const glm::ivec3& size, scene::VoxelGrid::Type type, int channels, test::Random& random) {
  SCOPED_TRACE(testing::Message() << "size " << size.x << " " << size.y << " " << size.z << ", type "
                                  << static_cast<int>(type) << ", channels " << channels);
  const auto grid = test::makeGrid(type, size, channels);
  test::fillRandomly(*grid, random);
  const int channel = channels - 1;
  const MacroCells cells(*grid, channel);
  EXPECT_TRUE(cells.finite());
  for (int axis = 0; axis < 3; ++axis)
    ASSERT_EQ(cells.size()[axis], std::max(1, (size[axis] - 1 + kSide - 1) / kSide));
  ASSERT_EQ(cells.ranges().size(), static_cast<size_t>(cells.size().x * cells.size().y * cells.size().z));
  test::eachVoxel(cells.size(), [&](const glm::ivec3& cell) { expectRange(*grid, channel, cells, cell); });
  expectBounds(*grid, channel, cells, random);
}

TEST(MacroCells, BoundSamplesOfEveryLengthOfAnAxis) {
  test::Random random(1);
  for (int axis = 0; axis < 3; ++axis)
    for (int length = 1; length <= 20; ++length)
      for (const scene::VoxelGrid::Type type : test::kVoxelTypes) {
        glm::ivec3 size(random.size(1, 3));
        size[axis] = length;
        expectCells(size, type, 1, random);
      }
}

TEST(MacroCells, BoundSamplesOfRandomSizes) {
  test::Random random(2);
  for (int i = 0; i < 10; ++i)
    for (const scene::VoxelGrid::Type type : test::kVoxelTypes) {
      const glm::ivec3 size = random.size(1, 20);
      expectCells(size, type, random.integer(1, 4), random);
    }
}

TEST(MacroCells, SignedNumbersEndAtMinusOne) {
  const auto grid = test::makeGrid(scene::VoxelGrid::Type::signedByte, {2, 1, 1});
  test::store(*grid, {0, 0, 0}, -128), test::store(*grid, {1, 0, 0}, 64);
  const MacroCells cells(*grid, 0);
  EXPECT_EQ(cells.ranges()[0].least, -1);
  EXPECT_EQ(cells.ranges()[0].most, 64 / 127.0f);
}

TEST(MacroCells, ACellThatHasNoNumberIsEverything) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (const float odd : {std::numeric_limits<float>::quiet_NaN(), kInfinity, -kInfinity})
    for (const int place : {0, 7, 8, 9, 16, 19}) {
      const auto grid = test::makeGrid(scene::VoxelGrid::Type::single, {20, 9, 3});
      test::store(*grid, {place, 4, 1}, double{odd});
      const MacroCells cells(*grid, 0);
      EXPECT_FALSE(cells.finite()) << odd << " at " << place;
      for (int x = 0; x < 3; ++x) {
        const bool inside = place >= kSide * x && place <= kSide * (x + 1);
        EXPECT_EQ(cells.ranges()[static_cast<size_t>(x)].most, inside ? kInfinity : 0);
        EXPECT_EQ(cells.ranges()[static_cast<size_t>(x)].least, inside ? -kInfinity : 0);
      }
    }
}

TEST(MacroCells, OtherChannelsDoNotCount) {
  const auto grid = test::makeGrid(scene::VoxelGrid::Type::single, {4, 4, 4}, 2);
  test::store(*grid, {1, 2, 3}, double{std::numeric_limits<float>::quiet_NaN()}, 1);
  EXPECT_TRUE(MacroCells(*grid, 0).finite());
  EXPECT_FALSE(MacroCells(*grid, 1).finite());
}

}  // namespace
}  // namespace gluray::accel
