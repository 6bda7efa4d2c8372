#include "accel/world.h"

#include "accel/device/error.h"
#include "accel/testing/test_rays.h"
#include "accel/testing/test_scene.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace gluray::accel {
namespace {

using test::makeMesh;
using test::makeSnapshot;
using test::MeshData;
using test::squareData;

RayPacket shoot(const World& world, float x, float y, const HitFilter* filter = nullptr) {
  return test::shot(world, test::raysDown(x, y), filter);
}

bool hits(const World& world, float x, float y) { return shoot(world, x, y).geometry[0] != kNoHit; }

struct WorldTest : testing::Test {
  Arena arena{2};
  World world;
  UpdateStatistics update(const scene::Snapshot& s) { return world.update(s, arena); }
};

TEST_F(WorldTest, SingleMeshHasNoTopLevel) {
  const UpdateStatistics statistics = update(makeSnapshot({makeMesh(squareData(2))}));
  EXPECT_EQ(statistics.blasBuilds, 1u);
  EXPECT_EQ(statistics.tlasBuilds, 0u);
  const RayPacket packet = shoot(world, 0.5f, -0.25f);
  for (int i = 0; i < kLanes; ++i) {
    EXPECT_EQ(packet.instance[i], 0u);
    EXPECT_EQ(packet.primitive[i], 0u);
    EXPECT_FLOAT_EQ(packet.tFar[i], 8);
  }
  EXPECT_FALSE(hits(world, 1.5f, 0));
}

TEST_F(WorldTest, InstancesBearTheirIndex) {
  const auto mesh = makeMesh(squareData());
  auto snapshot = makeSnapshot({mesh, makeMesh({}), mesh});
  snapshot.instances[2].worldFromObject[3] = {5, 0, 1, 1};
  const UpdateStatistics statistics = update(snapshot);
  EXPECT_EQ(statistics.blasBuilds, 1u);
  EXPECT_EQ(statistics.tlasBuilds, 1u);
  EXPECT_EQ(shoot(world, 0, 0.5f).instance[3], 0u);
  const RayPacket moved = shoot(world, 5, 0.5f);
  EXPECT_EQ(moved.instance[3], 2u);
  EXPECT_FLOAT_EQ(moved.tFar[3], 9);
}

TEST_F(WorldTest, OnlyMovedInstancesRebuildTheTopLevel) {
  const auto mesh = makeMesh(squareData());
  auto snapshot = makeSnapshot({mesh, mesh});
  snapshot.instances[1].worldFromObject[3] = {5, 0, 0, 1};
  update(snapshot);
  UpdateStatistics again = update(snapshot);
  EXPECT_EQ(again.blasBuilds + again.tlasBuilds, 0u);
  snapshot.instances[1].worldFromObject[3] = {0, 5, 0, 1};
  again = update(snapshot);
  EXPECT_EQ(again.blasBuilds, 0u);
  EXPECT_EQ(again.tlasBuilds, 1u);
  EXPECT_FALSE(hits(world, 5, 0.5f));
  EXPECT_TRUE(hits(world, 0.5f, 5));
}

TEST_F(WorldTest, CoincidenceIsTestedForEachTopLevel) {
  const auto mesh = makeMesh(squareData()), other = makeMesh(squareData(1));
  auto twice = makeSnapshot({mesh, mesh}), apart = makeSnapshot({mesh, other}), lone = makeSnapshot({mesh});
  for (int round = 0; round < 3; ++round) {
    update(twice);
    EXPECT_TRUE(world.mayCoincide()) << round;
    update(lone);
    EXPECT_FALSE(world.mayCoincide()) << round;
    update(twice);
    EXPECT_TRUE(world.mayCoincide()) << round;
    update(apart);
    EXPECT_FALSE(world.mayCoincide()) << round;
    update(lone);
    update(apart);
    EXPECT_FALSE(world.mayCoincide()) << round;
  }
}

TEST_F(WorldTest, RemovedInstancesAreNotHit) {
  const auto mesh = makeMesh(squareData());
  auto snapshot = makeSnapshot({mesh, mesh, mesh});
  for (int i = 0; i < 3; ++i)
    snapshot.instances[static_cast<size_t>(i)].worldFromObject[3] = {5 * i, 0, 0, 1};
  update(snapshot);
  snapshot.instances.pop_back();
  update(snapshot);
  EXPECT_TRUE(hits(world, 5, 0.5f));
  EXPECT_FALSE(hits(world, 10, 0.5f));
}

TEST_F(WorldTest, EqualGeometryIsBuiltOnce) {
  MeshData red = squareData(), green = squareData();
  red.colors.assign(4, {1, 0, 0, 1});
  green.colors.assign(4, {0, 1, 0, 1});
  EXPECT_EQ(update(makeSnapshot({makeMesh(red)})).blasBuilds, 1u);
  EXPECT_EQ(update(makeSnapshot({makeMesh(green)})).blasBuilds, 0u);
  EXPECT_EQ(update(makeSnapshot({makeMesh(red), makeMesh(green)})).blasBuilds, 0u);
}

TEST_F(WorldTest, EachQualityIsBuilt) {
  auto snapshot = makeSnapshot({makeMesh(squareData())});
  for (const BvhQuality quality : {BvhQuality::fast, BvhQuality::full, BvhQuality::compact}) {
    snapshot.settings.bvh = quality;
    EXPECT_EQ(update(snapshot).blasBuilds, 1u);
    EXPECT_TRUE(hits(world, 0, 0.5f));
  }
}

TEST_F(WorldTest, SoupsOfGrowingSize) {
  for (const int triangles : {1, 100, 20000, 50}) {
    MeshData soup;
    for (int i = 0; i < triangles; ++i) {
      const float x = static_cast<float>(2 * i);
      soup.positions.insert(soup.positions.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}});
    }
    update(makeSnapshot({makeMesh(soup)}));
    const RayPacket packet = shoot(world, static_cast<float>(2 * (triangles - 1)) + 0.25f, 0.25f);
    EXPECT_EQ(packet.primitive[0], static_cast<uint32_t>(triangles - 1));
  }
}

TEST_F(WorldTest, PositionsOfAnyStride) {
  struct Vertex {
    float x, y, z, other[4];
  };
  auto mesh = std::make_shared<scene::Mesh>(*makeMesh(squareData()));
  mesh->positions =
      test::makeAttribute<Vertex>({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, scene::Format::float3);
  ASSERT_EQ(mesh->positions.stride, 28u);
  update(makeSnapshot({mesh}));
  EXPECT_TRUE(hits(world, 0.9f, 0.8f));
}

TEST_F(WorldTest, TrianglesThatAreNotFiniteAreLeftOut) {
  MeshData data = squareData();
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  data.positions.insert(data.positions.end(), {{nan, 0, 1}, {inf, 0, 1}, {0, -inf, 1}});
  data.indices.insert(data.indices.end(), {0, 1, 4, 0, 1, 5, 1, 2, 6, 4, 5, 6});
  update(makeSnapshot({makeMesh(data)}));
  EXPECT_FLOAT_EQ(shoot(world, 0.5f, -0.25f).tFar[0], 10);
  EXPECT_FALSE(hits(world, 3, 0));

  data.indices = {4, 5, 6};
  update(makeSnapshot({makeMesh(data)}));
  EXPECT_TRUE(world.empty());
}

TEST_F(WorldTest, SingularTransformsAreRefused) {
  const auto mesh = makeMesh(squareData());
  auto snapshot = makeSnapshot({mesh, mesh});
  snapshot.instances[1].worldFromObject[2][2] = 0;
  EXPECT_THROW(update(snapshot), Error);
  EXPECT_TRUE(world.empty());
  snapshot.instances[1].worldFromObject[2][2] = std::nanf("");
  EXPECT_THROW(update(snapshot), Error);
  snapshot.instances[1].worldFromObject[2][2] = 1;
  EXPECT_NO_THROW(update(snapshot));
}

TEST_F(WorldTest, FailedCommitsMayBeRetried) {
  const auto mesh = makeMesh(squareData());
  auto snapshot = makeSnapshot({mesh, mesh});
  snapshot.instances[1].worldFromObject[3] = {5, 0, 0, 1};
  failNextCommits(1);
  EXPECT_THROW(update(snapshot), Error);  // the BLAS
  EXPECT_TRUE(world.empty());
  EXPECT_EQ(world.cachedBlases(), 0u);
  const auto other = makeSnapshot({mesh});
  update(other);
  failNextCommits(1);
  EXPECT_THROW(update(snapshot), Error);  // the TLAS
  EXPECT_EQ(update(snapshot).tlasBuilds, 1u);
  EXPECT_TRUE(hits(world, 5, 0.5f));
}

/// Overwrites the part of the stack that calls before this one used.
[[gnu::noinline]] void overwriteStack() {
  std::array<volatile unsigned char, 65536> bytes;
  for (volatile unsigned char& byte : bytes) byte = 0xAB;
}

// To cancel the tasks of a failed commit, TBB visits the contexts of all scenes and their parents, which must
// still exist.
TEST_F(WorldTest, CommitsMayFailAfterMeshesWereBuiltTogether) {
  const auto squareAt = [](float x) {
    auto data = squareData();
    for (glm::vec3& p : data.positions) p.x += x;
    return makeMesh(data);
  };
  for (int round = 0; round < 8; ++round) {
    std::vector<scene::MeshPtr> together;
    for (int i = 0; i < 16; ++i) together.push_back(squareAt(static_cast<float>(round * 100 + i)));
    EXPECT_EQ(update(makeSnapshot(together)).blasBuilds, 16u);
    overwriteStack();
    const auto snapshot = makeSnapshot({squareAt(static_cast<float>(round * 100 + 50))});
    failNextCommits(1);
    EXPECT_EQ(update(snapshot).blasBuilds, 1u);  // once the other structures have been freed
    EXPECT_EQ(commitsStillToFail(), 0);
    EXPECT_TRUE(hits(world, static_cast<float>(round * 100 + 50), 0.5f));
  }
}

TEST_F(WorldTest, FilterSeesThroughCoincidentTriangles) {
  struct Reject : HitFilter {
    uint32_t primitive;
    explicit Reject(uint32_t p) : primitive(p) {}
    bool accepts(uint32_t instance, uint32_t p, float, float, int) const noexcept override {
      return instance == 0 && p != primitive;
    }
  };
  MeshData data;
  data.positions = {{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}, {-1, -1, -3}, {1, -1, -3}, {-1, 1, -3}};
  data.indices = {0, 1, 2, 1, 0, 2, 3, 4, 5};  // one triangle in both windings, and one behind it
  update(makeSnapshot({makeMesh(data)}));
  for (const uint32_t rejected : {0u, 1u}) {
    const Reject filter(rejected);
    const RayPacket packet = shoot(world, -0.3f, -0.4f, &filter);
    for (int i = 0; i < kLanes; ++i) {
      EXPECT_EQ(packet.primitive[i], 1 - rejected);
      EXPECT_FLOAT_EQ(packet.tFar[i], 10);
    }
  }
}

}  // namespace
}  // namespace gluray::accel
