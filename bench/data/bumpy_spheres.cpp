#include "bench/data/bumpy_spheres.h"

#include "bench/data/orbit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace gluray::bench {
namespace {

constexpr double kBump = 0.04;      // of the radius
constexpr double kInnermost = 0.3;  // of the outermost radius

/// The surface's point and its derivatives by longitude and latitude give its normal.
struct Bumps {
  double radius;
  /// r(u, v): u is the longitude, v the angle from the pole, in radians.
  double at(double u, double v) const {
    const double fade = std::sin(v) * std::sin(v);  // one radius at each pole
    return radius * (1 + kBump * fade * std::sin(12 * u) * std::sin(14 * v)) / (1 + kBump);
  }
  std::array<double, 3> point(double u, double v) const {
    const double r = at(u, v);
    return {r * std::sin(v) * std::cos(u), r * std::cos(v), -r * std::sin(v) * std::sin(u)};
  }
  std::array<double, 3> normal(double u, double v) const {
    constexpr double h = 1e-4;
    v = std::clamp(v, 1e-3, M_PI - 1e-3);
    const auto a = point(u + h, v), b = point(u - h, v), c = point(u, v + h), d = point(u, v - h);
    const std::array<double, 3> du{a[0] - b[0], a[1] - b[1], a[2] - b[2]},
        dv{c[0] - d[0], c[1] - d[1], c[2] - d[2]};
    std::array<double, 3> n{dv[1] * du[2] - dv[2] * du[1], dv[2] * du[0] - dv[0] * du[2],
                            dv[0] * du[1] - dv[1] * du[0]};
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (double& value : n) value /= length;
    return n;
  }
};

Vertex vertex(const std::array<double, 3>& p) { return {float(p[0]), float(p[1]), float(p[2])}; }

/// A grid of `rows` by 2 * rows cells of two triangles; the first and last vertices of a row are equal.
void add(const Bumps& bumps, uint32_t rows, TriangleMesh& mesh) {
  const uint32_t columns = 2 * rows, first = uint32_t(mesh.positions.size());
  for (uint32_t y = 0; y <= rows; ++y)
    for (uint32_t x = 0; x <= columns; ++x) {
      const double u = 2 * M_PI * (x % columns) / columns, v = M_PI * y / rows;
      mesh.positions.push_back(vertex(bumps.point(u, v)));
      mesh.normals.push_back(vertex(bumps.normal(u, v)));
    }
  for (uint32_t y = 0; y < rows; ++y)
    for (uint32_t x = 0; x < columns; ++x) {
      const uint32_t a = first + y * (columns + 1) + x, b = a + 1, c = a + columns + 1, d = c + 1;
      for (const uint32_t index : {a, c, b, b, c, d}) mesh.indices.push_back(index);
    }
}

}  // namespace

TriangleMesh bumpySpheres(int count, double triangles) {
  if (count < 1) throw std::invalid_argument("no sphere is asked for");
  const auto rows = uint32_t(std::max(4.0, std::round(std::sqrt(triangles / count / 4))));
  TriangleMesh mesh;
  for (int i = 0; i < count; ++i) {
    const double place = count > 1 ? double(i) / (count - 1) : 1;
    add({kDataReach * (kInnermost + (1 - kInnermost) * place)}, rows, mesh);
  }
  mesh.positions.reserve(mesh.positions.size() + 1);
  return mesh;
}

}  // namespace gluray::bench
