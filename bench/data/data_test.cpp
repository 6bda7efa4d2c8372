// The benchmark's data: the Wavelet's known range, and meshes with known topology, orientation and area.
#include "bench/data/cube_cases.h"
#include "bench/data/isosurface.h"
#include "bench/data/report.h"
#include "bench/data/wavelet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace gluray::bench {
namespace {

/// radius - distance from the centre, on a grid of `count` points across [-1, 1] (z stretched to [-2, 2]):
/// the surface 0 is a sphere of that radius.
Volume sphereField(int count, float radius) {
  Volume out;
  out.size = {count, count, 2 * count - 1};
  const float step = 2.0f / float(count - 1);
  out.origin = {-1, -1, -2};
  out.spacing = {step, step, step};
  for (int z = 0; z < out.size[2]; ++z)
    for (int y = 0; y < count; ++y)
      for (int x = 0; x < count; ++x)
        out.values.push_back(radius -
                             std::hypot(-1 + step * float(x), -1 + step * float(y), -2 + step * float(z)));
  return out;
}

Vertex minus(const Vertex& a, const Vertex& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(const Vertex& a, const Vertex& b) {
  return double(a.x) * b.x + double(a.y) * b.y + double(a.z) * b.z;
}
Vertex cross(const Vertex& a, const Vertex& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// How often each directed edge occurs, minus how often its reverse does; all zero for a closed, consistently
/// turned surface.
std::map<std::pair<uint32_t, uint32_t>, int> edgeBalance(const TriangleMesh& mesh) {
  std::map<std::pair<uint32_t, uint32_t>, int> balance;
  for (size_t t = 0; t < mesh.triangleCount(); ++t)
    for (size_t i = 0; i < 3; ++i) {
      const uint32_t a = mesh.indices[3 * t + i], b = mesh.indices[3 * t + (i + 1) % 3];
      balance[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  return balance;
}

size_t unbalanced(const TriangleMesh& mesh) {
  size_t count = 0;
  for (const auto& [edge, balance] : edgeBalance(mesh)) count += balance != 0;
  return count;
}

TEST(CubeCases, EveryCrossedEdgeIsUsedAndNoOther) {
  for (int inside = 0; inside < 256; ++inside) {
    std::set<int> crossed, used;
    for (int e = 0; e < 12; ++e)
      if ((inside >> kCubeEdges[size_t(e)][0] & 1) != (inside >> kCubeEdges[size_t(e)][1] & 1))
        crossed.insert(e);
    const CubeCase& cell = cubeCases()[size_t(inside)];
    for (int i = 0; i < 3 * cell.triangleCount; ++i) used.insert(cell.edges[size_t(i)]);
    EXPECT_EQ(crossed, used) << "case " << inside;
  }
}

TEST(Isosurface, SphereIsClosedWithSharedVertices) {
  const TriangleMesh mesh = isosurfaces(sphereField(41, 0.7f), {0.0f});
  ASSERT_GT(mesh.triangleCount(), 5000u);
  EXPECT_EQ(unbalanced(mesh), 0u);
  // Euler: vertices - edges + faces = 2, and edges = 3/2 faces, where every vertex is shared.
  EXPECT_EQ(mesh.positions.size(), 2 + mesh.triangleCount() / 2);
}

TEST(Isosurface, EveryAmbiguousFaceIsClosedToo) {
  // A field of alternating signs within an outside border: every inner cell is ambiguous on all six faces.
  Volume field;
  field.size = {12, 12, 12};
  for (int z = 0; z < 12; ++z)
    for (int y = 0; y < 12; ++y)
      for (int x = 0; x < 12; ++x) {
        const bool border = x % 11 == 0 || y % 11 == 0 || z % 11 == 0;
        field.values.push_back(border || ((x + y + z) & 1) || (x * y * z) % 7 == 3 ? -1.0f
                                                                                   : 1.0f + float(x % 3));
      }
  const TriangleMesh mesh = isosurfaces(field, {0.0f});
  ASSERT_GT(mesh.triangleCount(), 1000u);
  EXPECT_EQ(unbalanced(mesh), 0u);
}

TEST(Isosurface, TrianglesAndNormalsPointOutwards) {
  const TriangleMesh mesh = isosurfaces(sphereField(41, 0.7f), {0.0f});
  for (size_t t = 0; t < mesh.triangleCount(); ++t) {
    const Vertex& a = mesh.positions[mesh.indices[3 * t]];
    const Vertex& b = mesh.positions[mesh.indices[3 * t + 1]];
    const Vertex& c = mesh.positions[mesh.indices[3 * t + 2]];
    EXPECT_GE(dot(cross(minus(b, a), minus(c, a)), a), 0.0) << "triangle " << t;
  }
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_NEAR(dot(mesh.normals[v], mesh.normals[v]), 1.0, 1e-5);
    EXPECT_GT(dot(mesh.normals[v], mesh.positions[v]), 0.995 * 0.7) << "vertex " << v;
  }
}

TEST(Isosurface, SphereHasItsArea) {
  const TriangleMesh mesh = isosurfaces(sphereField(81, 0.7f), {0.0f});
  double area = 0;
  for (size_t t = 0; t < mesh.triangleCount(); ++t) {
    const Vertex& a = mesh.positions[mesh.indices[3 * t]];
    const Vertex n = cross(minus(mesh.positions[mesh.indices[3 * t + 1]], a),
                           minus(mesh.positions[mesh.indices[3 * t + 2]], a));
    area += 0.5 * std::sqrt(dot(n, n));
  }
  // Chords lie inside the sphere: with 28 cells a radius the area is short by about (step/radius)^2/4.
  EXPECT_NEAR(area, 4 * M_PI * 0.7 * 0.7, 0.002 * area);
}

TEST(Isosurface, SeveralSurfacesFollowOneAnother) {
  const Volume field = sphereField(41, 0.7f);
  const TriangleMesh both = isosurfaces(field, {0.0f, 0.3f});
  const TriangleMesh first = isosurfaces(field, {0.0f}), second = isosurfaces(field, {0.3f});
  ASSERT_EQ(both.triangleCount(), first.triangleCount() + second.triangleCount());
  for (size_t i = 0; i < first.indices.size(); ++i) ASSERT_EQ(both.indices[i], first.indices[i]);
  for (size_t i = 0; i < second.indices.size(); ++i)
    ASSERT_EQ(both.indices[first.indices.size() + i], second.indices[i] + first.positions.size());
}

TEST(Isosurface, ItsSizeIsKnownInAdvance) {
  const Volume field = sphereField(17, 0.7f);
  const std::vector<float> isovalues{-0.3f, 0, 0.31f};
  const TriangleMesh mesh = isosurfaces(field, isovalues);
  const MeshSize size = sizeOfIsosurfaces(field, isovalues);
  EXPECT_GT(size.triangles, 0u);
  EXPECT_EQ(size.vertices, mesh.positions.size());
  EXPECT_EQ(size.triangles, mesh.triangleCount());
}

TEST(Isosurface, NothingOutsideTheRange) {
  EXPECT_EQ(isosurfaces(sphereField(11, 0.7f), {5.0f}).triangleCount(), 0u);
  EXPECT_EQ(isosurfaces(sphereField(11, 0.7f), {}).positions.size(), 0u);
}

TEST(Wavelet, HasParaViewsRange) {
  const auto [low, high] = wavelet().range();
  EXPECT_NEAR(low, 33.951, 0.0006);
  EXPECT_NEAR(high, 286.341, 0.0006);
}

TEST(Wavelet, ThreeSurfacesAre870ThousandTriangles) {
  const Volume field = wavelet();
  const auto [low, high] = field.range();
  const TriangleMesh mesh = isosurfaces(field, evenIsovalues(low, high, 3));
  EXPECT_NEAR(double(mesh.triangleCount()), 0.87e6, 0.01e6);
}

TEST(Report, QuartilesLieBetweenValues) {
  EXPECT_EQ(quartiles({}), (std::pair{0.0, 0.0}));
  EXPECT_EQ(quartiles({3}), (std::pair{3.0, 3.0}));
  EXPECT_EQ(quartiles({5, 1, 2, 4, 3}), (std::pair{2.0, 4.0}));
  EXPECT_EQ(quartiles({4, 1, 2, 3}), (std::pair{1.75, 3.25}));
}

TEST(Volume, RefinementKeepsPointsAndReproducesQuadratics) {
  Volume field;
  field.size = {5, 4, 6};
  const auto value = [](float x, float y, float z) { return x * x - 2 * y + 0.5f * z * z + x * z; };
  for (int z = 0; z < 6; ++z)
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 5; ++x) field.values.push_back(value(float(x), float(y), float(z)));
  const Volume fine = refined(field, 2);
  ASSERT_EQ(fine.size, (std::array<int, 3>{9, 7, 11}));
  EXPECT_FLOAT_EQ(fine.spacing[0], 0.5f);
  EXPECT_FLOAT_EQ(fine.at(4, 2, 6), field.at(2, 1, 3));
  EXPECT_NEAR(fine.at(3, 3, 5), value(1.5f, 1.5f, 2.5f), 1e-5);  // away from the border
}

TEST(Volume, SmoothingSpreadsAPoint) {
  Volume field;
  field.size = {5, 5, 5};
  field.values.assign(125, 0.0f);
  field.values[2 + 5 * (2 + 5 * 2)] = 64;
  const Volume soft = smoothed(field, 1);
  EXPECT_FLOAT_EQ(soft.at(2, 2, 2), 8);
  EXPECT_FLOAT_EQ(soft.at(1, 2, 2), 4);
  EXPECT_FLOAT_EQ(soft.at(1, 1, 3), 1);
  EXPECT_FLOAT_EQ(soft.at(0, 2, 2), 0);
}

}  // namespace
}  // namespace gluray::bench
