// Voxel grids for the tests of accel/ and render/, and what OpenGL's filters make of them, in doubles.
#pragma once
#include "scene/volumes/voxel_grid.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <random>

namespace gluray::test {

using scene::VoxelGrid;

inline constexpr VoxelGrid::Type kVoxelTypes[] = {VoxelGrid::Type::byte, VoxelGrid::Type::signedByte,
                                                  VoxelGrid::Type::word, VoxelGrid::Type::signedWord,
                                                  VoxelGrid::Type::single};

/// An empty grid.
inline std::shared_ptr<VoxelGrid> makeGrid(VoxelGrid::Type type, const glm::ivec3& size, int channels = 1) {
  auto grid = std::make_shared<VoxelGrid>();
  grid->type = type, grid->size = size, grid->channels = channels;
  grid->values = std::make_unique<std::byte[]>(grid->bytes() + VoxelGrid::kPadding);
  // What lies behind the voxels must not be seen.
  std::fill_n(grid->values.get() + grid->bytes(), VoxelGrid::kPadding, std::byte{0x7f});
  return grid;
}

inline size_t indexOf(const VoxelGrid& grid, const glm::ivec3& voxel, int channel = 0) {
  const auto of = [](int n) { return static_cast<size_t>(n); };
  return ((of(channel) * of(grid.size.z) + of(voxel.z)) * of(grid.size.y) + of(voxel.y)) * of(grid.size.x) +
         of(voxel.x);
}

/// Calls body with a pointer to the values as they are stored.
template <class Grid, class Body>
auto withStored(Grid& grid, const Body& body) {
  switch (grid.type) {
    case VoxelGrid::Type::byte: return body(reinterpret_cast<uint8_t*>(grid.values.get()));
    case VoxelGrid::Type::signedByte: return body(reinterpret_cast<int8_t*>(grid.values.get()));
    case VoxelGrid::Type::word: return body(reinterpret_cast<uint16_t*>(grid.values.get()));
    case VoxelGrid::Type::signedWord: return body(reinterpret_cast<int16_t*>(grid.values.get()));
    default: return body(reinterpret_cast<float*>(grid.values.get()));
  }
}

/// Stores a number as it is: rounded where the type is an integer.
inline void store(VoxelGrid& grid, const glm::ivec3& voxel, double number, int channel = 0) {
  withStored(grid, [&](auto* stored) {
    using Stored = std::remove_reference_t<decltype(*stored)>;
    if constexpr (std::is_integral_v<Stored>) number = std::round(number);
    stored[indexOf(grid, voxel, channel)] = static_cast<Stored>(number);
  });
}

/// Value that a texture returns for a voxel (OpenGL 4.6, 2.3.5).
inline double valueOf(const VoxelGrid& grid, const glm::ivec3& voxel, int channel = 0) {
  return withStored(grid, [&](const auto* stored) {
    const double number = static_cast<double>(stored[indexOf(grid, voxel, channel)]);
    return std::max(number / double{scene::divisorOf(grid.type)},
                    grid.type == VoxelGrid::Type::single ? -std::numeric_limits<double>::infinity() : -1.0);
  });
}

template <class Body>
void eachVoxel(const glm::ivec3& size, const Body& body) {
  for (int z = 0; z < size.z; ++z)
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) body(glm::ivec3(x, y, z));
}

/// GL_LINEAR with GL_CLAMP_TO_EDGE at texture coordinates.
inline double linearAt(const VoxelGrid& grid, const glm::dvec3& at, int channel = 0) {
  const glm::dvec3 size(grid.size), u = glm::clamp(at * size - 0.5, glm::dvec3(0), size - 1.0);
  const glm::ivec3 low(glm::floor(u)), high = glm::min(low + 1, grid.size - 1);
  const glm::dvec3 share = u - glm::dvec3(low);
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    glm::ivec3 voxel = low;
    double weight = 1;
    for (int axis = 0; axis < 3; ++axis) {
      const bool upper = corner >> axis & 1;
      if (upper) voxel[axis] = high[axis];
      weight *= upper ? share[axis] : 1 - share[axis];
    }
    if (weight > 0) sum += weight * valueOf(grid, voxel, channel);
  }
  return sum;
}

/// GL_NEAREST with GL_CLAMP_TO_EDGE.
inline double nearestAt(const VoxelGrid& grid, const glm::dvec3& at, int channel = 0) {
  const glm::ivec3 voxel(glm::floor(at * glm::dvec3(grid.size)));
  return valueOf(grid, glm::clamp(voxel, glm::ivec3(0), grid.size - 1), channel);
}

/// Random numbers, one a call.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double real(double least = 0, double most = 1) {
    return least + (most - least) * (static_cast<double>(engine_()) / 4294967296.0);
  }
  int integer(int least, int most) {
    return least + static_cast<int>(engine_() % static_cast<unsigned>(most - least + 1));
  }
  glm::ivec3 size(int least, int most) {
    glm::ivec3 size;
    for (int axis = 0; axis < 3; ++axis) size[axis] = integer(least, most);
    return size;
  }
  glm::dvec3 point(double least = 0, double most = 1) {
    glm::dvec3 point;
    for (int axis = 0; axis < 3; ++axis) point[axis] = real(least, most);
    return point;
  }

 private:
  std::mt19937 engine_;
};

/// Fills a grid with numbers between those for the least and the greatest value of its type, both of them
/// among them. Floats lie between `least` and `most`.
inline void fillRandomly(VoxelGrid& grid, Random& random, double least = -2, double most = 3) {
  const double divisor = double{scene::divisorOf(grid.type)};
  const bool isSigned = grid.type == VoxelGrid::Type::signedByte || grid.type == VoxelGrid::Type::signedWord;
  if (grid.type != VoxelGrid::Type::single) least = isSigned ? -divisor : 0, most = divisor;
  eachVoxel(grid.size, [&](const glm::ivec3& voxel) {
    for (int c = 0; c < grid.channels; ++c) {
      const int which = random.integer(0, 9);
      const double number = random.real(least, most);
      store(grid, voxel, which == 0 ? least : which == 1 ? most : number, c);
    }
  });
}

}  // namespace gluray::test
