// Lines through fields whose lines are known; tubes with known counts, volume and topology; waves, mesh
// files.
#include "bench/data/tubes.h"

#include "bench/data/isosurface.h"
#include "bench/data/mesh_file.h"
#include "bench/data/waves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>

namespace gluray::bench {
namespace {

const Within kEverywhere = [](const Point&) { return true; };

/// Volume inside the mesh, by the divergence theorem: positive where triangles turn outwards.
double volumeOf(const TriangleMesh& mesh) {
  double sum = 0;
  for (size_t t = 0; t < mesh.triangleCount(); ++t) {
    const Vertex &a = mesh.positions[mesh.indices[3 * t]], &b = mesh.positions[mesh.indices[3 * t + 1]],
                 &c = mesh.positions[mesh.indices[3 * t + 2]];
    sum += a.x * (double(b.y) * c.z - double(b.z) * c.y) + a.y * (double(b.z) * c.x - double(b.x) * c.z) +
           a.z * (double(b.x) * c.y - double(b.y) * c.x);
  }
  return sum / 6;
}

/// Directed edges that have no reverse.
size_t openEdges(const TriangleMesh& mesh) {
  std::map<std::pair<uint32_t, uint32_t>, int> balance;
  for (size_t t = 0; t < mesh.triangleCount(); ++t)
    for (size_t i = 0; i < 3; ++i) {
      const uint32_t a = mesh.indices[3 * t + i], b = mesh.indices[3 * t + (i + 1) % 3];
      balance[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  size_t open = 0;
  for (const auto& [edge, sum] : balance) open += sum != 0;
  return open;
}

TEST(Streamline, FollowsACircle) {
  const Field around = [](const Point& p) { return Point{-p[2], 0, p[0]}; };
  const Line line = streamline(around, {3, 1, 0}, 0.1, 200, kEverywhere);
  ASSERT_EQ(line.size(), 201u);
  for (const Point& p : line) {
    EXPECT_NEAR(std::hypot(p[0], p[2]), 3, 1e-4);  // steps are as long as the arcs they cut
    EXPECT_EQ(p[1], 1);
  }
  // 20 units of length are 20/3 radians.
  EXPECT_NEAR(line.back()[0], 3 * std::cos(20.0 / 3), 0.01);
  EXPECT_NEAR(line.back()[2], 3 * std::sin(20.0 / 3), 0.01);
}

TEST(Streamline, EndsWhereItLeavesAndWhereThereIsNoField) {
  const Field ahead = [](const Point&) { return Point{5, 0, 0}; };
  const Line line = streamline(ahead, {0, 0, 0}, 1, 100, [](const Point& p) { return p[0] <= 3.5; });
  EXPECT_EQ(line.size(), 4u);
  EXPECT_EQ(streamline([](const Point&) { return Point{}; }, {0, 0, 0}, 1, 9, kEverywhere).size(), 1u);
}

TEST(Streamline, ResamplingKeepsEndsAndEvensSteps) {
  const Line line = resampled({{0, 0, 0}, {1, 0, 0}, {1, 3, 0}}, 8);
  ASSERT_EQ(line.size(), 9u);
  EXPECT_EQ(line.front(), (Point{0, 0, 0}));
  EXPECT_EQ(line.back(), (Point{1, 3, 0}));
  EXPECT_EQ(line[1], (Point{0.5, 0, 0}));
  EXPECT_EQ(line[4], (Point{1, 1, 0}));
}

TEST(Tubes, AreClosedAndHaveTheirVolume) {
  const Line straight{{1, 2, 3}, {1, 4, 3}, {1, 9, 3}};
  const TriangleMesh mesh = tubes({straight}, 0.5, 6);
  EXPECT_EQ(mesh.triangleCount(), tubeTriangles(2, 6));
  EXPECT_EQ(mesh.triangleCount(), 32u);
  EXPECT_EQ(openEdges(mesh), 0u);
  EXPECT_NEAR(volumeOf(mesh), 7 * 3 * std::sin(M_PI / 3) * 0.25, 1e-4);
}

TEST(Tubes, KeepTheirRingsAcrossAndUntwisted) {
  Line helix;
  for (int i = 0; i <= 400; ++i) helix.push_back({3 * std::cos(0.05 * i), 0.05 * i, 3 * std::sin(0.05 * i)});
  const TriangleMesh mesh = tubes({helix}, 0.2, 5);
  EXPECT_EQ(openEdges(mesh), 0u);
  const double length = 400 * 0.05 * std::hypot(3.0, 1.0);
  EXPECT_NEAR(volumeOf(mesh), length * 2.5 * std::sin(2 * M_PI / 5) * 0.04, 0.002 * length);
  for (size_t i = 5; i < mesh.normals.size(); ++i) {  // each corner turns little against the one before it
    const Vertex &a = mesh.normals[i], &b = mesh.normals[i - 5];
    EXPECT_GT(a.x * b.x + a.y * b.y + a.z * b.z, 0.99f);
  }
}

TEST(Tubes, LinesWithoutLengthHaveNone) {
  const Point p{1, 1, 1};
  EXPECT_EQ(tubes({{}, {p}, {p, p}}, 1, 3).triangleCount(), 0u);
  const TriangleMesh some = tubes({{p}, {p, {2, 1, 1}}, {p, p}}, 1, 3);
  EXPECT_EQ(some.triangleCount(), tubeTriangles(1, 3));
  EXPECT_EQ(openEdges(some), 0u);
}

TEST(Waves, HaveMeanSquareOneAndTheirRange) {
  const std::vector<Wave> field = waves(24, 2, 50, 0.8, 3);
  double squares = 0;
  for (const Wave& wave : field) {
    const double k = std::hypot(wave.k[0], wave.k[1], wave.k[2]);
    EXPECT_GE(k, 2 - 1e-9);
    EXPECT_LE(k, 50 + 1e-9);
    squares += wave.amplitude * wave.amplitude / 2;
  }
  EXPECT_NEAR(squares, 1, 1e-9);
}

TEST(Waves, RowsAgreeWithTheFormula) {
  const std::vector<Wave> field = waves(5, 1, 9, 1, 8);
  const WaveRows rows(field, {7, 4, 3}, {-1, 2, 0.5f}, {0.25f, 0.5f, 0.125f});
  std::vector<float> row;
  for (int z = 0; z < 3; ++z)
    for (int y = 0; y < 4; ++y) {
      rows.row(y, z, row);
      ASSERT_EQ(row.size(), 7u);
      for (int x = 0; x < 7; ++x) {
        double want = 0;
        for (const Wave& wave : field) want += wave.at({-1 + 0.25 * x, 2 + 0.5 * y, 0.5 + 0.125 * z});
        EXPECT_NEAR(row[size_t(x)], want, 1e-5);
      }
    }
}

TEST(IsosurfaceInSlabs, EqualsThatOfTheWholeGrid) {
  const std::array<int, 3> size{20, 18, 23};
  const auto value = [](int x, int y, int z) {
    return 7 - std::hypot(float(x) - 9.3f, float(y) - 8.6f, float(z) - 11.1f);
  };
  const FillPlane fill = [&](int z, float* to) {
    for (int y = 0; y < size[1]; ++y)
      for (int x = 0; x < size[0]; ++x) *to++ = value(x, y, z);
  };
  Volume whole;
  whole.size = size;
  whole.values.resize(size_t(20 * 18 * 23));
  for (int z = 0; z < size[2]; ++z) fill(z, whole.values.data() + whole.rowIndex(0, z));
  const TriangleMesh want = isosurfaces(whole, {0}), got = isosurfaceInSlabs(size, fill, 0, 4);
  ASSERT_EQ(got.triangleCount(), want.triangleCount());
  EXPECT_GT(got.positions.size(), want.positions.size());  // vertices on seams are duplicated
  for (size_t i = 0; i < want.indices.size(); ++i) {
    const Vertex &a = want.positions[want.indices[i]], &b = got.positions[got.indices[i]];
    const Vertex &n = want.normals[want.indices[i]], &m = got.normals[got.indices[i]];
    ASSERT_TRUE(a.x == b.x && a.y == b.y) << i;
    ASSERT_NEAR(a.z, b.z, 2e-6) << i;  // rounded from another plane
    if (a.z == std::floor(a.z)) { ASSERT_EQ(a.z, b.z) << "a crack between slabs"; }
    ASSERT_TRUE(n.x == m.x && n.y == m.y && n.z == m.z) << i;
  }
}

class MeshFile : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(path_); }
  std::string path_ = (std::filesystem::temp_directory_path() /
                       ("gluray_mesh_file_" +
                        std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".mesh"))
                          .string();
};

TEST_F(MeshFile, RoundTrips) {
  const TriangleMesh mesh = tubes({{{0, 0, 0}, {0, 1, 0}}}, 1, 3);
  writeMesh(mesh, path_);
  const TriangleMesh back = readMesh(path_);
  ASSERT_EQ(back.positions.size(), mesh.positions.size());
  ASSERT_EQ(back.indices, mesh.indices);
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    EXPECT_EQ(back.positions[i].x, mesh.positions[i].x);
    EXPECT_EQ(back.normals[i].z, mesh.normals[i].z);
  }
}

TEST_F(MeshFile, RefusesInvalidFiles) {
  EXPECT_THROW(readMesh(path_), std::runtime_error);
  std::ofstream(path_) << "something else altogether, which is long enough";
  EXPECT_THROW(readMesh(path_), std::runtime_error);
  TriangleMesh mesh = tubes({{{0, 0, 0}, {0, 1, 0}}}, 1, 3);
  writeMesh(mesh, path_);
  std::filesystem::resize_file(path_, std::filesystem::file_size(path_) - 4);
  EXPECT_THROW(readMesh(path_), std::runtime_error);
  mesh.indices[4] = 99;
  writeMesh(mesh, path_);
  EXPECT_THROW(readMesh(path_), std::runtime_error);
}

}  // namespace
}  // namespace gluray::bench
