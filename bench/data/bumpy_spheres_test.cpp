// Nested spheres: as many triangles as asked for, one inside the other, facing outwards, normals along them.
#include "bench/data/bumpy_spheres.h"

#include "bench/data/orbit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace gluray::bench {
namespace {

double dot(const Vertex& a, const Vertex& b) {
  return double(a.x) * b.x + double(a.y) * b.y + double(a.z) * b.z;
}

/// The smallest and largest distance from the origin of a part of the vertices.
std::pair<double, double> distances(const TriangleMesh& mesh, size_t first, size_t end) {
  double low = 1e30, high = 0;
  for (size_t i = first; i < end; ++i) {
    const double length = std::sqrt(dot(mesh.positions[i], mesh.positions[i]));
    low = std::min(low, length), high = std::max(high, length);
  }
  return {low, high};
}

TEST(BumpySpheres, LieInsideEachOther) {
  const TriangleMesh mesh = bumpySpheres(12, 120000);
  EXPECT_NEAR(double(mesh.triangleCount()), 120000, 6000);
  const size_t each = mesh.positions.size() / 12;
  double inner = 0;
  for (size_t sphere = 0; sphere < 12; ++sphere) {
    const auto [low, high] = distances(mesh, sphere * each, (sphere + 1) * each);
    EXPECT_LT(inner, high);
    EXPECT_LT(high / low, 1.1);
    inner = high;
  }
  EXPECT_LE(inner, kDataReach * 1.0001);
  EXPECT_GT(inner, kDataReach * 0.97);
}

TEST(BumpySpheres, FaceOutwards) {
  const TriangleMesh mesh = bumpySpheres(1, 20000);
  double volume = 0;
  for (size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Vertex &a = mesh.positions[mesh.indices[i]], &b = mesh.positions[mesh.indices[i + 1]],
                 &c = mesh.positions[mesh.indices[i + 2]];
    const Vertex ab{b.x - a.x, b.y - a.y, b.z - a.z}, ac{c.x - a.x, c.y - a.y, c.z - a.z};
    const Vertex n{ab.y * ac.z - ab.z * ac.y, ab.z * ac.x - ab.x * ac.z, ab.x * ac.y - ab.y * ac.x};
    volume += dot(a, n) / 6;
    const double area = std::sqrt(dot(n, n));
    if (area > 1e-3) { EXPECT_GT(dot(n, mesh.normals[mesh.indices[i]]) / area, 0.8); }
  }
  const double ball = 4 * M_PI / 3 * std::pow(kDataReach, 3);
  EXPECT_GT(volume, 0.8 * ball);
  EXPECT_LT(volume, ball);
}

TEST(BumpySpheres, NoSphereIsAnError) { EXPECT_THROW(bumpySpheres(0, 1000), std::invalid_argument); }

}  // namespace
}  // namespace gluray::bench
