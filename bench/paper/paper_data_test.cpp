// The stand-ins for the paper's data: sizes, places, and the same mesh on any number of threads.
#include "bench/paper/paper_data.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

namespace gluray::bench {
namespace {

struct DataSet {
  const char* name;
  TriangleMesh (*make)(double);
  double smallest;  // of the real size, by the one asked for, at a quarter of a million
};

void PrintTo(const DataSet& data, std::ostream* out) { *out << data.name; }

class PaperData : public testing::TestWithParam<DataSet> {};

/// FNV-1a over the bits of the whole mesh.
uint64_t hashOf(const TriangleMesh& mesh) {
  uint64_t hash = 0xcbf29ce484222325u;
  const auto add = [&](const void* data, size_t bytes) {
    const auto* at = static_cast<const unsigned char*>(data);
    for (size_t i = 0; i < bytes; ++i) hash = (hash ^ at[i]) * 0x100000001b3u;
  };
  add(mesh.positions.data(), mesh.positions.size() * sizeof(Vertex));
  add(mesh.normals.data(), mesh.normals.size() * sizeof(Vertex));
  add(mesh.indices.data(), mesh.indices.size() * sizeof(uint32_t));
  return hash;
}

TEST_P(PaperData, HasAboutTheRequestedSize) {
  const double triangles = double(GetParam().make(0.25).triangleCount());
  EXPECT_GT(triangles, GetParam().smallest * 0.25e6);
  EXPECT_LT(triangles, 1.05 * 0.25e6);
}

TEST_P(PaperData, LiesWithinItsSphereAndFillsMuchOfIt) {
  const TriangleMesh mesh = GetParam().make(0.1);
  double farthest = 0;
  for (const Vertex& v : mesh.positions) farthest = std::max(farthest, std::hypot(double(v.x), v.y, v.z));
  EXPECT_LE(farthest, kReach);
  EXPECT_GT(farthest, 0.8 * kReach);
}

TEST_P(PaperData, HasUnitNormalsAndVerticesOfItsOwn) {
  const TriangleMesh mesh = GetParam().make(0.05);
  ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
  for (const Vertex& n : mesh.normals) ASSERT_NEAR(std::hypot(n.x, n.y, n.z), 1, 1e-4);
  for (const uint32_t index : mesh.indices) ASSERT_LT(index, mesh.positions.size());
}

TEST_P(PaperData, IsTheSameOnAnyNumberOfThreads) {
  const uint64_t many = hashOf(GetParam().make(0.05));
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(hashOf(GetParam().make(0.05)), many);
}

INSTANTIATE_TEST_SUITE_P(All, PaperData,
                         testing::Values(DataSet{"mixing", mixingInterface, 0.85},
                                         DataSet{"plasma", plasma, 0.85}, DataSet{"star", star, 0.98}),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(Star, HasThePapersLinesAtItsSize) {
  EXPECT_EQ(starLineCount(86), 48000);
  EXPECT_NEAR(48000.0 * double(tubeTriangles(kStarSegments, 6)), 86.2e6, 0.01e6);
}

TEST(Star, LinesBeginAtItsSurfaceAndStayOutside) {
  const std::vector<Line> lines = starLines(500);
  ASSERT_EQ(lines.size(), 500u);
  size_t back = 0;
  for (const Line& line : lines) {
    ASSERT_EQ(line.size(), size_t(kStarSegments) + 1);
    EXPECT_NEAR(std::hypot(line[0][0], line[0][1], line[0][2]), 70.07, 1e-6);
    for (const Point& p : line) ASSERT_GT(std::hypot(p[0], p[1], p[2]), 69.0);
    back += std::hypot(line.back()[0], line.back()[1], line.back()[2]) < 75;
  }
  EXPECT_GT(back, 100u) << "field lines go round from pole to pole";
}

}  // namespace
}  // namespace gluray::bench
