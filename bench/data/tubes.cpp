#include "bench/data/tubes.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace gluray::bench {
namespace {

Point along(const Point& from, double length, const Point& way) {
  return {from[0] + length * way[0], from[1] + length * way[1], from[2] + length * way[2]};
}
Point minus(const Point& a, const Point& b) { return along(a, -1, b); }
double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double length(const Point& a) { return std::sqrt(dot(a, a)); }
Point unit(const Point& a) {
  const double l = length(a);
  return l > 0 ? Point{a[0] / l, a[1] / l, a[2] / l} : Point{};
}
/// `a` mirrored at the plane through the origin across `normal`, of any length but 0.
Point mirrored(const Point& a, const Point& normal) {
  return along(a, -2 * dot(normal, a) / dot(normal, normal), normal);
}
/// Some direction at right angles to `a`, of length 1.
Point across(const Point& a) {
  return unit(cross(a, std::abs(a[1]) < 0.9 ? Point{0, 1, 0} : Point{1, 0, 0}));
}

bool hasTube(const Line& line) {
  if (line.size() < 2) return false;
  for (size_t i = 1; i < line.size(); ++i)
    if (line[i] == line[i - 1]) return false;
  return true;
}

Point tangent(const Line& line, size_t i) {
  const Point in = i > 0 ? unit(minus(line[i], line[i - 1])) : Point{};
  const Point out = i + 1 < line.size() ? unit(minus(line[i + 1], line[i])) : Point{};
  const Point middle = unit(along(in, 1, out));
  return length(middle) > 0 ? middle : in;  // a line that turns right back
}

/// Where one tube begins in the mesh.
struct Place {
  size_t vertex = 0, index = 0;
};

void emitTube(const Line& line, double radius, int sides, const Place& place, TriangleMesh& mesh) {
  const auto ring = static_cast<size_t>(sides);
  Point ahead = tangent(line, 0), side = across(ahead);
  for (size_t i = 0; i < line.size(); ++i) {
    if (i > 0) {  // two mirrors carry the frame along without twist
      const Point step = minus(line[i], line[i - 1]), next = tangent(line, i);
      const Point sideMirrored = mirrored(side, step), change = minus(next, mirrored(ahead, step));
      side = length(change) > 0 ? mirrored(sideMirrored, change) : sideMirrored;
      ahead = next;
    }
    const Point up = cross(ahead, side);
    for (size_t s = 0; s < ring; ++s) {
      const double angle = 2 * M_PI * double(s) / sides;
      Point n{};
      for (size_t axis = 0; axis < 3; ++axis)
        n[axis] = std::cos(angle) * side[axis] + std::sin(angle) * up[axis];
      const Point p = along(line[i], radius, n);
      mesh.positions[place.vertex + ring * i + s] = {float(p[0]), float(p[1]), float(p[2])};
      mesh.normals[place.vertex + ring * i + s] = {float(n[0]), float(n[1]), float(n[2])};
    }
  }
  size_t at = place.index;
  const auto triangle = [&](size_t a, size_t b, size_t c) {
    for (const size_t corner : {a, b, c}) mesh.indices[at++] = uint32_t(place.vertex + corner);
  };
  for (size_t i = 0; i + 1 < line.size(); ++i)
    for (size_t s = 0; s < ring; ++s) {
      const size_t a = ring * i + s, b = ring * i + (s + 1) % ring;
      triangle(a, b, b + ring);
      triangle(a, b + ring, a + ring);
    }
  const size_t last = ring * (line.size() - 1);
  for (size_t s = 1; s + 1 < ring; ++s) {
    triangle(0, s + 1, s);
    triangle(last, last + s, last + s + 1);
  }
}

void resize(TriangleMesh& mesh, size_t vertices, size_t indices) {
  if (vertices > std::numeric_limits<uint32_t>::max())
    throw std::runtime_error("the mesh has more vertices than its indices can tell");
  mesh.positions.reserve(vertices + 2);  // so that 16 bytes can be read at the last one
  mesh.positions.resize(vertices);
  mesh.normals.resize(vertices);
  mesh.indices.resize(indices);
}

}  // namespace

Line streamline(const Field& field, const Point& seed, double step, int segments, const Within& within) {
  Line line{seed};
  const auto direction = [&](const Point& at) { return unit(field(at)); };
  for (int i = 0; i < segments; ++i) {
    const Point& at = line.back();
    const Point a = direction(at), b = direction(along(at, step / 2, a)),
                c = direction(along(at, step / 2, b)), d = direction(along(at, step, c));
    Point sum{};
    for (size_t axis = 0; axis < 3; ++axis) sum[axis] = a[axis] + 2 * b[axis] + 2 * c[axis] + d[axis];
    if (length(sum) < 1) break;  // the field vanishes or turns within one step
    const Point next = along(at, step, unit(sum));
    if (!within(next)) break;
    line.push_back(next);
  }
  return line;
}

Line resampled(const Line& line, int segments) {
  if (line.size() < 2) return line.empty() ? Line{} : Line{line.front()};
  std::vector<double> reached{0};
  for (size_t i = 1; i < line.size(); ++i)
    reached.push_back(reached.back() + length(minus(line[i], line[i - 1])));
  Line out;
  size_t piece = 0;
  for (int i = 0; i <= segments; ++i) {
    const double want = reached.back() * i / segments;
    while (piece + 2 < line.size() && reached[piece + 1] < want) ++piece;
    const double whole = reached[piece + 1] - reached[piece];
    const double t = whole > 0 ? (want - reached[piece]) / whole : 0;
    out.push_back(along(line[piece], t, minus(line[piece + 1], line[piece])));
  }
  return out;
}

size_t tubeTriangles(size_t segments, int sides) {
  return 2 * size_t(sides) * segments + 2 * size_t(sides - 2);
}

TriangleMesh tubes(const std::vector<Line>& lines, double radius, int sides) {
  std::vector<Place> places(lines.size());
  Place end;
  for (size_t i = 0; i < lines.size(); ++i) {
    places[i] = end;
    if (!hasTube(lines[i])) continue;
    end.vertex += lines[i].size() * size_t(sides);
    end.index += 3 * tubeTriangles(lines[i].size() - 1, sides);
  }
  TriangleMesh mesh;
  resize(mesh, end.vertex, end.index);
  tbb::parallel_for(size_t(0), lines.size(), [&](size_t i) {
    if (hasTube(lines[i])) emitTube(lines[i], radius, sides, places[i], mesh);
  });
  return mesh;
}

}  // namespace gluray::bench
