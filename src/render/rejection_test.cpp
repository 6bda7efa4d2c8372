// Culling and clip planes.
#include "render/testing/test_trace.h"

#include <gtest/gtest.h>

#include <functional>

namespace gluray {
namespace {

using scene::CullFace;
using test::makeMesh;
using test::makeSnapshot;
using test::trace;

// A counterclockwise square at z = 0.5 and a clockwise one behind it at z = -0.5.
scene::MeshPtr bothWays() {
  test::MeshData data = test::squareData(0.5f);
  const test::MeshData back = test::squareData(-0.5f);
  data.positions.insert(data.positions.end(), back.positions.begin(), back.positions.end());
  for (const uint32_t i : {4, 6, 5, 4, 7, 6}) data.indices.push_back(i);
  return makeMesh(data);
}

constexpr float kFrontDepth = 0.25f, kBackDepth = 0.75f;

void expectDepth(const scene::Snapshot& s, float depth) {
  const auto traced = trace(s);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) ASSERT_FLOAT_EQ(traced.depth(x, y), depth) << x << ' ' << y;
  }
}

TEST(Culling, EachMode) {
  auto s = makeSnapshot({bothWays()});
  expectDepth(s, kFrontDepth);
  s.instances[0].cull = CullFace::back;
  expectDepth(s, kFrontDepth);
  s.instances[0].cull = CullFace::front;
  expectDepth(s, kBackDepth);
  s.instances[0].cull = CullFace::both;
  expectDepth(s, Image::kMiss);
  s.instances[0].cull = CullFace::back;
  s.instances[0].frontFaceCcw = false;
  expectDepth(s, kBackDepth);
}

TEST(Culling, MirroredModelview) {
  auto s = makeSnapshot({bothWays()});
  s.instances[0].eyeFromObject[0][0] = s.eyeFromWorld[0][0] = -1;
  s.instances[0].cull = CullFace::back;
  expectDepth(s, kBackDepth);
}

TEST(Culling, MirroredInstance) {
  auto s = makeSnapshot({bothWays()});
  s.instances[0].worldFromObject[1][1] = -1;
  s.instances[0].eyeFromObject[1][1] = -1;
  s.instances[0].cull = CullFace::back;
  expectDepth(s, kBackDepth);
}

TEST(Culling, MirroredProjection) {
  auto s = makeSnapshot({bothWays()});
  s.camera.clipFromEye[1][1] = -1;
  s.instances[0].cull = CullFace::back;
  expectDepth(s, kBackDepth);
}

TEST(Culling, CoincidentTrianglesOfOppositeWinding) {
  test::MeshData data = test::squareData(0.3f);
  for (const uint32_t i : {0, 2, 1, 0, 3, 2}) data.indices.push_back(i);
  auto s = makeSnapshot({makeMesh(data)});
  for (const CullFace cull : {CullFace::front, CullFace::back}) {
    s.instances[0].cull = cull;
    expectDepth(s, 0.35f);
  }
}

TEST(Culling, OneInstanceOfTwo) {
  auto s = makeSnapshot({makeMesh(test::squareData(0.5f)), makeMesh(test::squareData(-0.5f))});
  s.instances[0].cull = CullFace::front;
  expectDepth(s, kBackDepth);
}

// Expects the square at z = 0.5 if `kept`, otherwise the one behind it or a miss.
void expectKept(const scene::Snapshot& s, const std::function<bool(double, double)>& kept, float elsewhere) {
  const auto traced = trace(s);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) {
      const double ex = (x + 0.5) / 8 - 1, ey = (y + 0.5) / 8 - 1;
      ASSERT_FLOAT_EQ(traced.depth(x, y), kept(ex, ey) ? kFrontDepth : elsewhere) << x << ' ' << y;
    }
  }
}

TEST(ClipPlanes, SharedByAll) {
  auto s = makeSnapshot({bothWays()});
  s.instances[0].clipPlanes = {{1, 0.3, 0, 0.11}, {0, -1, 0, 0.5}};
  expectKept(
      s, [](double x, double y) { return x + 0.3 * y + 0.11 >= 0 && y <= 0.5; }, Image::kMiss);
  s.instances[0].clipPlanes = {{0, 0, -1, 0}};  // clips the nearer square
  expectDepth(s, kBackDepth);
  s.instances[0].clipPlanes = {{0, 0, 0, -1}};
  expectDepth(s, Image::kMiss);
}

TEST(ClipPlanes, ActInEyeSpace) {
  auto s = makeSnapshot({bothWays()});
  s.instances[0].eyeFromObject[0][0] = s.eyeFromWorld[0][0] = 2;
  s.instances[0].clipPlanes = {{1, 0, 0, -0.3}};
  expectKept(
      s, [](double x, double) { return x >= 0.3; }, Image::kMiss);
}

TEST(ClipPlanes, OfSingleInstances) {
  auto s = makeSnapshot({makeMesh(test::squareData(0.5f)), makeMesh(test::squareData(-0.5f))});
  s.instances[0].clipPlanes = {{1, 0.3, 0, 0.11}, {0, 1, 0, 0.4}};
  expectKept(
      s, [](double x, double y) { return x + 0.3 * y + 0.11 >= 0 && y >= -0.4; }, kBackDepth);
}

TEST(ClipPlanes, WithCulling) {
  auto s = makeSnapshot({bothWays(), makeMesh(test::squareData(-0.9f))});
  s.instances[0].clipPlanes = {{1, 0, 0, 0}};
  s.instances[0].cull = CullFace::front;
  const auto traced = trace(s);
  EXPECT_FLOAT_EQ(traced.depth(12, 5), kBackDepth);
  EXPECT_FLOAT_EQ(traced.depth(3, 5), 0.95f);
}

}  // namespace
}  // namespace gluray
