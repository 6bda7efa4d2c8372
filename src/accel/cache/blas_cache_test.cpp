// Eviction of idle structures.
#include "accel/meshes/blas.h"
#include "accel/testing/test_scene.h"
#include "accel/world.h"

#include <gtest/gtest.h>

namespace gluray::accel {
namespace {

using test::makeMesh;
using test::makeSnapshot;
using test::squareData;

struct BlasCacheTest : testing::Test {
  Arena arena{2};
  World world;
  UpdateStatistics update(const scene::Snapshot& s) { return world.update(s, arena); }
};

TEST_F(BlasCacheTest, IdleStructuresAreEvictedBeyondTheBudget) {
  World small(0);
  small.update(makeSnapshot({makeMesh(squareData(0))}), arena);
  small.update(makeSnapshot({makeMesh(squareData(1))}), arena);
  EXPECT_EQ(small.cachedBlases(), 1u);
  update(makeSnapshot({makeMesh(squareData(0))}));
  update(makeSnapshot({makeMesh(squareData(1))}));
  EXPECT_EQ(world.cachedBlases(), 2u);
  EXPECT_GT(world.bytes(), 0u);
}

TEST_F(BlasCacheTest, StructuresOfLostMeshesAreReleased) {
  const auto kept = makeSnapshot({makeMesh(squareData(0))});
  update(kept);
  update(makeSnapshot({makeMesh(squareData(1))}));
  EXPECT_EQ(world.cachedBlases(), 2u) << "the mesh is gone, and its content may come back";
  world.releaseOrphans();
  EXPECT_EQ(world.cachedBlases(), 1u);
  EXPECT_EQ(update(kept).blasBuilds, 0u);
  update(makeSnapshot({makeMesh(squareData(1))}));
  const auto again = makeSnapshot({makeMesh(squareData(1))});
  EXPECT_EQ(update(again).blasBuilds, 0u) << "of equal content";
  world.releaseOrphans();
  EXPECT_EQ(world.cachedBlases(), 2u) << "it belongs to the new mesh";
}

// A frame of two batches: during each, the other's structure is idle.
TEST_F(BlasCacheTest, RecentStructuresAreKeptWhileMemoryIsFree) {
  const auto first = makeSnapshot({makeMesh(squareData(0))}),
             second = makeSnapshot({makeMesh(squareData(1))});
  const auto buildsOfTwoFrames = [&](FreeMemory memory) {
    World tight(1, memory);
    uint64_t builds = 0;
    for (const auto& snapshot : {first, second, first, second})
      builds += tight.update(snapshot, arena).blasBuilds;
    return builds;
  };
  EXPECT_EQ(buildsOfTwoFrames([] { return size_t{64} << 30; }), 2u);
  EXPECT_EQ(buildsOfTwoFrames([] { return size_t{0}; }), 4u);
}

// Larger than the share of memory for recent structures, but within free memory.
TEST_F(BlasCacheTest, StructuresRequestedAgainAfterEvictionAreKept) {
  static size_t free;
  const auto mesh = makeMesh(squareData(0));
  Device device;
  IotaIndices iota;
  Blas blas(device, iota, {mesh.get(), {}}, BvhQuality::full);
  blas.build();
  World tight(1, [] { return free; });
  uint64_t frame = 0;
  const auto buildsOfFrame = [&](int batches, int firstMesh = 0) {
    uint64_t builds = 0;
    ++frame;
    for (int i = 0; i < batches; ++i) {
      auto snapshot = makeSnapshot({makeMesh(squareData(firstMesh + i))});
      snapshot.frame = frame;
      builds += tight.update(snapshot, arena).blasBuilds;
    }
    return builds;
  };
  for (const int batches : {2, 3, 30}) {
    free = (batches + 1) * (blas.bvhBytes() + blas.pinnedBytes());
    for (int i = 0; i < 3; ++i) buildsOfFrame(batches);
    EXPECT_EQ(buildsOfFrame(batches), 0u) << batches << " batches a frame";
  }
  free = 3 * (blas.bvhBytes() + blas.pinnedBytes());
  for (int i = 0; i < 20; ++i) buildsOfFrame(1, 30 + i);
  EXPECT_LE(tight.cachedBlases(), 4u) << "geometry that is new in every frame";
}

}  // namespace
}  // namespace gluray::accel
