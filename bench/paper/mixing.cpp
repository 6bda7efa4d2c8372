#include "bench/data/isosurface.h"
#include "bench/data/waves.h"
#include "bench/paper/paper_data.h"

#include <algorithm>
#include <cmath>

namespace gluray::bench {
namespace {

constexpr float kHalfWidth = 115;              // world units
constexpr double kTrianglesPerColumn = 12.75;  // measured: of the surface, for each column of cells

/// Long swells of the surface, the same at every height.
std::vector<Wave> swells() {
  std::vector<Wave> out = waves(12, 5, 16, 1.0, 11);
  for (Wave& wave : out) wave.k[1] = 0;
  return out;
}

}  // namespace

TriangleMesh mixingInterface(double millionTriangles) {
  const int count = std::max(16, int(std::lround(std::sqrt(millionTriangles * 1e6 / kTrianglesPerColumn))));
  const std::array<int, 3> size{count, count * 2 / 5, count};
  const float step = 2.0f / float(count - 1);  // in halves of a side
  const std::array<float, 3> origin{-1, -0.5f * step * float(size[1] - 1), -1};
  const std::array<float, 3> spacing{step, step, step};
  const WaveRows swell(swells(), size, origin, spacing);
  const WaveRows turbulence(waves(72, 9, 200, 0.7, 23), size, origin, spacing);
  // Positive above the surface: height - 0.08 swells - 0.3 turbulence, which fades away from the middle.
  const auto fill = [&](int z, float* row) {
    std::vector<float> a, b;
    for (int y = 0; y < size[1]; ++y, row += count) {
      swell.row(y, z, a);
      turbulence.row(y, z, b);
      const float height = origin[1] + step * float(y);
      const float fading = std::exp(-(height / 0.22f) * (height / 0.22f));
      for (size_t x = 0; x < a.size(); ++x) row[x] = 0.08f * a[x] + 0.3f * fading * b[x] - height;
    }
  };
  TriangleMesh mesh = isosurfaceInSlabs(size, fill, 0);
  place(mesh, origin, step, kHalfWidth);
  return mesh;
}

}  // namespace gluray::bench
