// A scalar field on a regular grid, the input of isosurfaces. Used by the benchmarks and the demo; any
// thread.
#pragma once
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace gluray::bench {

/// Values at the points of a regular grid; x runs fastest: values[x + size[0] * (y + size[1] * z)].
/// Point (x, y, z) lies at origin + spacing * (x, y, z).
struct Volume {
  std::array<int, 3> size{};  // grid points along x, y, z, each >= 2
  std::array<float, 3> origin{};
  std::array<float, 3> spacing{1, 1, 1};  // world units between neighbours
  std::vector<float> values;

  size_t rowIndex(int y, int z) const { return size_t(size[0]) * (size_t(y) + size_t(size[1]) * size_t(z)); }
  float at(int x, int y, int z) const { return values[rowIndex(y, z) + size_t(x)]; }
  /// Smallest and largest value; {0, 0} for an empty volume.
  std::pair<float, float> range() const;
};

/// The volume with each axis refined `factor` times by Catmull-Rom interpolation (the same box, factor * (n -
/// 1) + 1 points). Smooth first derivatives keep isosurfaces free of the coarse grid's facets. factor >= 1.
Volume refined(const Volume& volume, int factor);

/// The volume smoothed along each axis by the binomial kernel (1 2 1)/4, `passes` times; edges are repeated
/// outwards.
Volume smoothed(const Volume& volume, int passes);

}  // namespace gluray::bench
