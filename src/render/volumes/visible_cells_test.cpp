// Which macro cells are empty, and how far they are from those that are not.
#include "render/volumes/visible_cells.h"

#include "accel/testing/test_grids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gluray::render {
namespace {

/// Entries of which most are 0.
scene::VolumeTable sparseTable(test::Random& random, int entries) {
  scene::VolumeTable table;
  table.linear = random.integer(0, 1) == 1;
  for (int i = 0; i < entries; ++i)
    table.values.push_back(random.integer(0, 5) == 0 ? static_cast<float>(random.real(0.01, 1)) : 0);
  return table;
}

/// Whether one of the entries `first` to `last` is not 0; beyond the ends it is those at the ends.
bool anyEntry(const scene::VolumeTable& table, int first, int last) {
  const int end = table.entries() - 1;
  for (int i = std::clamp(first, 0, end); i <= std::clamp(last, 0, end); ++i)
    if (table.values[static_cast<size_t>(i)] != 0) return true;
  return false;
}

/// Whether a filter meets an entry that is not 0 at a coordinate (OpenGL 4.6, 8.14.2).
bool isNonzeroAt(const scene::VolumeTable& table, double coordinate) {
  const double u = std::clamp(coordinate, 0.0, 1.0) * table.entries();
  if (!table.linear) return anyEntry(table, static_cast<int>(u), static_cast<int>(u));
  const int low = static_cast<int>(std::floor(u - 0.5));
  return anyEntry(table, low, u - 0.5 > low ? low + 1 : low);
}

TEST(NonzeroRanges, MissNothingAndKeepCloseToIt) {
  constexpr int kParts = 40;
  test::Random random(1);
  int missing = 0;
  for (int i = 0; i < 2000; ++i) {
    const scene::VolumeTable table = sparseTable(random, random.integer(1, 300));
    const NonzeroRanges ranges(table);
    const double a = random.real(-0.2, 1.2), b = random.integer(0, 3) == 0 ? a : random.real(-0.2, 1.2);
    const double least = std::min(a, b), most = std::max(a, b);
    bool nonzero = false;
    for (int k = 0; k <= kParts; ++k) nonzero |= isNonzeroAt(table, least + (most - least) * k / kParts);
    const bool found = ranges.any(static_cast<float>(least), static_cast<float>(most));
    EXPECT_TRUE(found || !nonzero) << least << " .. " << most << " of " << table.entries();
    const auto entryAt = [&](double v) {
      return static_cast<int>(std::floor(std::clamp(v, 0.0, 1.0) * table.entries()));
    };
    if (!anyEntry(table, entryAt(least) - 3, entryAt(most) + 3)) {
      EXPECT_FALSE(found) << least << " .. " << most << " of " << table.entries();
      ++missing;
    }
  }
  EXPECT_GT(missing, 100);
}

TEST(NonzeroRanges, OfEmptyTablesAndOfNoNumbers) {
  constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(NonzeroRanges({}).any(0, 1));
  scene::VolumeTable table;
  table.values.assign(100, 0.0f);
  EXPECT_FALSE(NonzeroRanges(table).any(kNoNumber, kNoNumber));
  for (const size_t entry : {0u, 50u, 99u}) {
    table.values.assign(100, 0.0f), table.values[entry] = 0.5f;
    EXPECT_TRUE(NonzeroRanges(table).any(kNoNumber, kNoNumber)) << entry;
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    EXPECT_TRUE(NonzeroRanges(table).any(-kInfinity, kInfinity)) << entry;
  }
}

/// A volume that shows numbers above 0.
scene::Volume volumeOf(const std::shared_ptr<const scene::VoxelGrid>& grid) {
  scene::Volume volume;
  volume.grid = grid;
  scene::VolumeTable& opacity = volume.channels[0].opacity;
  opacity.values.assign(64, 1.0f);
  std::fill_n(opacity.values.begin(), 8, 0.0f);
  return volume;
}

/// The distances by their definition.
std::vector<int> bruteDistances(const accel::MacroCells& cells, float scale, float bias) {
  std::vector<glm::ivec3> visible;
  size_t i = 0;
  test::eachVoxel(cells.size(), [&](const glm::ivec3& cell) {
    const accel::MacroCells::Range& range = cells.ranges()[i++];
    if (std::max(range.least * scale, range.most * scale) + bias > 0.5f) visible.push_back(cell);
  });
  std::vector<int> distances;
  test::eachVoxel(cells.size(), [&](const glm::ivec3& cell) {
    int least = 255;
    for (const glm::ivec3& other : visible) {
      const glm::ivec3 d = glm::abs(cell - other);
      least = std::min(least, std::max(d.x, std::max(d.y, d.z)));
    }
    distances.push_back(least);
  });
  return distances;
}

void expectDistances(const std::shared_ptr<const scene::VoxelGrid>& grid, float scale, float bias) {
  std::vector<accel::MacroCells> cells;
  cells.emplace_back(*grid, 0);
  scene::Volume volume = volumeOf(grid);
  volume.channels[0].scale = scale, volume.channels[0].bias = bias;
  const std::vector<uint8_t> found = emptySpace(cells, volume);
  const std::vector<int> expected = bruteDistances(cells.front(), scale, bias);
  EXPECT_EQ(std::vector<int>(found.begin(), found.end()), expected)
      << "cells " << cells.front().size().x << " " << cells.front().size().y << " " << cells.front().size().z
      << ", scale " << scale;
}

TEST(EmptySpace, HasTheDistancesToVisibleCells) {
  test::Random random(2);
  for (int i = 0; i < 60; ++i) {
    const bool inverted = random.integer(0, 1) == 1;
    const auto grid = test::makeGrid(scene::VoxelGrid::Type::single, random.size(1, 60));
    test::eachVoxel(grid->size,
                    [&](const glm::ivec3& voxel) { test::store(*grid, voxel, inverted ? 1 : 0); });
    for (int k = random.integer(0, 4); k > 0; --k) {
      const glm::ivec3 voxel = glm::ivec3(random.point() * glm::dvec3(grid->size));
      test::store(*grid, voxel, inverted ? 0 : 1);
    }
    expectDistances(grid, inverted ? -1.0f : 1.0f, inverted ? 1.0f : 0.0f);
  }
}

TEST(EmptySpace, OfATableIsWhatNoGradientShows) {
  const auto grid = test::makeGrid(scene::VoxelGrid::Type::single, {40, 3, 3});
  test::eachVoxel(grid->size, [&](const glm::ivec3& voxel) { test::store(*grid, voxel, voxel.x / 40.0); });
  std::vector<accel::MacroCells> cells;
  cells.emplace_back(*grid, 0);
  scene::Volume volume;
  volume.grid = grid, volume.use = scene::VolumeChannels::table;
  scene::VolumeTable2D table;
  table.size = {40, 3}, table.values.assign(120, glm::vec4(1, 1, 1, 0));
  const auto empty = [&] {
    volume.table = std::make_shared<scene::VolumeTable2D>(table);
    return emptySpace(cells, volume);
  };
  EXPECT_EQ(empty(), (std::vector<uint8_t>{255, 255, 255, 255, 255}));
  for (const size_t row : {0u, 1u, 2u}) {
    table.values[40 * row + 20].a = 0.1f;
    EXPECT_EQ(empty(), (std::vector<uint8_t>{2, 1, 0, 1, 2})) << row;
    table.values[40 * row + 20].a = 0;
  }
  volume.use = scene::VolumeChannels::labels;
  volume.channels[0].opacity.values.assign(40, 0.0f);
  EXPECT_EQ(empty(), (std::vector<uint8_t>{255, 255, 255, 255, 255}));
  volume.channels[0].opacity.values[36] = 1;
  EXPECT_EQ(empty(), (std::vector<uint8_t>{4, 3, 2, 1, 0})) << "visible without a label";
  volume.channels[0].opacity.values[36] = 0;
  table.values[0].a = table.values[119].a = 1;
  EXPECT_EQ(empty(), (std::vector<uint8_t>{0, 1, 2, 1, 0}));
}

TEST(EmptySpace, DistancesEndAt255) {
  const auto grid = test::makeGrid(scene::VoxelGrid::Type::byte, {8 * 300, 2, 3});
  expectDistances(grid, 1, 0);
  test::store(*grid, {0, 0, 0}, 255);
  expectDistances(grid, 1, 0);
  test::store(*grid, {8 * 270 + 4, 1, 2}, 255);
  expectDistances(grid, 1, 0);
}

}  // namespace
}  // namespace gluray::render
