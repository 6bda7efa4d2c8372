#include "bench/data/waves.h"
#include "bench/paper/paper_data.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace gluray::bench {
namespace {

constexpr int kSides = 6;
constexpr double kStarRadius = 70, kFarthest = 172;  // world units
constexpr double kMillionsOfAll = 86;                // with kLinesOfAll
constexpr int kLinesOfAll = 48000;

/// A point with a magnetic charge; of all together the charge is 0.
struct Charge {
  Point at;
  double strength;
};

/// Two large ones make the dipole, which leans; pairs close to each other under the surface the spots.
std::vector<Charge> charges() {
  std::vector<Charge> out{{{8, 30, 0}, 1}, {{-8, -30, 0}, -1}};
  for (uint64_t spot = 0; spot < 14; ++spot) {
    const Point place = directionOf(51, spot), way = directionOf(53, spot);
    for (const double sign : {1.0, -1.0}) {
      Point at;
      for (size_t axis = 0; axis < 3; ++axis) at[axis] = 60 * place[axis] + sign * 9 * way[axis];
      out.push_back({at, 0.3 * sign});
    }
  }
  return out;
}

Point magneticField(const std::vector<Charge>& charges, const Point& at) {
  Point out{};
  for (const Charge& charge : charges) {
    const Point from{at[0] - charge.at[0], at[1] - charge.at[1], at[2] - charge.at[2]};
    const double square = from[0] * from[0] + from[1] * from[1] + from[2] * from[2];
    const double scale = charge.strength / (square * std::sqrt(square));
    for (size_t axis = 0; axis < 3; ++axis) out[axis] += scale * from[axis];
  }
  return out;
}

double fromCentre(const Point& p) { return std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]); }

}  // namespace

int starLineCount(double millionTriangles) {
  return std::max(1, int(std::lround(kLinesOfAll * millionTriangles / kMillionsOfAll)));
}

std::vector<Line> starLines(int count, double step, int pieces) {
  const std::vector<Charge> all = charges();
  std::vector<Line> lines(static_cast<size_t>(count));
  tbb::parallel_for(size_t(0), lines.size(), [&](size_t i) {
    // Beginnings lie evenly over the sphere, each turned by the golden angle.
    const double height = 1 - (2 * double(i) + 1) / count, flat = std::sqrt(1 - height * height);
    const double angle = M_PI * (3 - std::sqrt(5.0)) * double(i);
    const double radius = 1.001 * kStarRadius;
    const Point seed{radius * flat * std::cos(angle), radius * height, radius * flat * std::sin(angle)};
    const Point there = magneticField(all, seed);
    const double out = there[0] * seed[0] + there[1] * seed[1] + there[2] * seed[2] < 0 ? -1 : 1;
    const Field field = [&](const Point& at) {
      Point b = magneticField(all, at);
      for (double& component : b) component *= out;
      return b;
    };
    const Line line = streamline(field, seed, step, int(600 / step), [](const Point& p) {
      const double r = fromCentre(p);
      return r >= kStarRadius && r <= kFarthest;
    });
    lines[i] = resampled(line, pieces);
  });
  return lines;
}

TriangleMesh star(double millionTriangles) {
  const int count = starLineCount(millionTriangles);
  return tubes(starLines(count), std::min(0.5, 30 / std::sqrt(double(count))), kSides);
}

}  // namespace gluray::bench
