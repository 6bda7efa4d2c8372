#include "bench/data/isosurface.h"
#include "bench/data/waves.h"
#include "bench/paper/paper_data.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace gluray::bench {
namespace {

constexpr float kHalf = 100;  // world units: half a side of the box
constexpr double kTrianglesPerColumn = 15, kSurfaceShare = 0.4;
constexpr int kTubeSides = 6, kTubeSegments = 400;
constexpr double kSheet = 0.22;  // half the sheet's thickness, in half sides

/// Structures of the current: long along the field, which goes along x, short across.
std::vector<Wave> filaments() {
  std::vector<Wave> out = waves(64, 10, 160, 0.7, 5);
  for (Wave& wave : out) wave.k[0] *= 0.35;
  return out;
}
std::vector<Wave> ripples() {
  std::vector<Wave> out = waves(8, 3, 9, 1.0, 7);
  for (Wave& wave : out) wave.k[1] = 0;
  return out;
}

/// An isosurface of the current's density, which is greatest in a rippled sheet about y = 0, torn by
/// filaments.
TriangleMesh sheet(double triangles) {
  const int count = std::max(16, int(std::lround(std::sqrt(triangles / kTrianglesPerColumn))));
  const std::array<int, 3> size{count, count * 7 / 10, count};
  const float step = 2.0f / float(count - 1);  // in halves of a side
  const std::array<float, 3> origin{-1, -0.5f * step * float(size[1] - 1), -1};
  const std::array<float, 3> spacing{step, step, step};
  const WaveRows ripple(ripples(), size, origin, spacing), filament(filaments(), size, origin, spacing);
  const auto fill = [&](int z, float* row) {
    std::vector<float> a, b;
    for (int y = 0; y < size[1]; ++y, row += count) {
      ripple.row(y, z, a);
      filament.row(y, z, b);
      const float height = origin[1] + step * float(y);
      for (size_t x = 0; x < a.size(); ++x) {
        const float away = (height - 0.12f * a[x]) / float(kSheet);
        row[x] = std::exp(-away * away) * (1 + 1.2f * b[x]);
      }
    }
  };
  TriangleMesh mesh = isosurfaceInSlabs(size, fill, 0.55f);
  place(mesh, origin, step, kHalf);
  return mesh;
}

/// The magnetic field: it turns round across the sheet, and waves without sources run through it.
class Magnetism {
 public:
  Magnetism() : waves_(waves(12, 3, 14, 1.2, 31)) {
    for (size_t i = 0; i < waves_.size(); ++i) {
      const Point e = directionOf(37, i), &k = waves_[i].k;
      const double l = std::sqrt(k[0] * k[0] + k[1] * k[1] + k[2] * k[2]);
      across_.push_back({(k[1] * e[2] - k[2] * e[1]) / l, (k[2] * e[0] - k[0] * e[2]) / l,
                         (k[0] * e[1] - k[1] * e[0]) / l});
    }
  }
  /// At a place in world units.
  Point operator()(const Point& world) const {
    const Point at{world[0] / kHalf, world[1] / kHalf, world[2] / kHalf};
    Point out{std::tanh(at[1] / kSheet), 0, 0.5};
    for (size_t i = 0; i < waves_.size(); ++i) {
      const double value = 0.35 * waves_[i].at(at);
      for (size_t axis = 0; axis < 3; ++axis) out[axis] += value * across_[i][axis];
    }
    return out;
  }

 private:
  std::vector<Wave> waves_;
  std::vector<Point> across_;
};

bool inBox(const Point& p) {
  return std::all_of(p.begin(), p.end(), [](double x) { return std::abs(x) <= kHalf; });
}

/// Lines that begin near the sheet, until their tubes have so many triangles.
std::vector<Line> fieldLines(size_t wanted) {
  const Magnetism field;
  std::vector<Line> out;
  constexpr size_t kBatch = 256;
  for (size_t triangles = 0; triangles < wanted;) {
    std::vector<Line> batch(kBatch);
    tbb::parallel_for(size_t(0), kBatch, [&](size_t i) {
      const uint64_t number = 3 * (out.size() + i);
      const auto place = [&](uint64_t axis, double half) {
        return kHalf * half * (2 * evenly(41, number + axis) - 1);
      };
      const Point seed{place(0, 0.98), place(1, 0.75), place(2, 0.98)};
      batch[i] = streamline(field, seed, 0.6, kTubeSegments, inBox);
    });
    for (Line& line : batch) {
      if (triangles >= wanted) break;
      if (line.size() >= 2) triangles += tubeTriangles(line.size() - 1, kTubeSides);
      out.push_back(std::move(line));
    }
  }
  return out;
}

}  // namespace

TriangleMesh plasma(double millionTriangles) {
  const double triangles = millionTriangles * 1e6;
  const std::vector<Line> lines = fieldLines(size_t((1 - kSurfaceShare) * triangles));
  // Thinner where there are more, so that they fill the same part of the box.
  const double radius = std::min(1.0, 20 / std::sqrt(double(lines.size())));
  std::vector<TriangleMesh> parts;
  parts.push_back(sheet(kSurfaceShare * triangles));
  parts.push_back(tubes(lines, radius, kTubeSides));
  return joined(std::move(parts));
}

}  // namespace gluray::bench
