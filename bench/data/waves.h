// Fields made of plane waves: the noise of the paper's stand-in data. The same numbers on every machine with
// the same libm; any thread.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gluray::bench {

/// Numbers in [0, 1), spread evenly, that depend on both arguments alone. Source: Steele, Lea and Flood,
/// SplitMix, 2014.
double evenly(uint64_t seed, uint64_t index);

/// A direction drawn evenly from the sphere, of length 1.
std::array<double, 3> directionOf(uint64_t seed, uint64_t index);

/// amplitude * cos(k . x + phase).
struct Wave {
  std::array<double, 3> k{};  // radians a unit of length
  double amplitude = 0, phase = 0;
  double at(const std::array<double, 3>& x) const;
};

/// `count` waves in all directions whose |k| grow geometrically from `lowest` to `highest` and whose
/// amplitudes fall as |k|^-slope; the sum of their squares is 2, so that the field's mean square is 1.
std::vector<Wave> waves(int count, double lowest, double highest, double slope, uint64_t seed);

/// Sums of waves along the rows of a regular grid, by tables of each wave along each axis.
class WaveRows {
 public:
  /// The grid's points lie at origin + spacing * (x, y, z), as in a Volume of `size`.
  WaveRows(const std::vector<Wave>& waves, const std::array<int, 3>& size, const std::array<float, 3>& origin,
           const std::array<float, 3>& spacing);
  /// The sum at the points (0, y, z) ... (size[0] - 1, y, z).
  void row(int y, int z, std::vector<float>& out) const;

 private:
  struct Table {
    std::vector<float> cosine, sine;  // by wave and place: place + places * wave
  };
  std::array<Table, 3> axes_;
  std::array<int, 3> size_;
  size_t count_;
};

}  // namespace gluray::bench
