// Full-quality BLASes built in the background; also run under the thread sanitizer.
#include "accel/device/device.h"
#include "accel/testing/test_rays.h"
#include "accel/testing/test_scene.h"
#include "accel/world.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

namespace gluray::accel {
namespace {

constexpr int kRefinedSide = 260;  // 2 * 260^2 triangles: just large enough for a fast first build

/// A wavy wavySheet over [-1, 1]^2; different `phase`, different geometry.
scene::MeshPtr wavySheet(float phase = 0, int side = kRefinedSide) {
  test::MeshData data;
  const auto row = static_cast<uint32_t>(side + 1);
  for (uint32_t y = 0; y < row; ++y)
    for (uint32_t x = 0; x < row; ++x) {
      const float u = 2 * static_cast<float>(x) / static_cast<float>(side) - 1,
                  v = 2 * static_cast<float>(y) / static_cast<float>(side) - 1;
      data.positions.push_back({u, v, 0.1f * std::sin(9 * u + phase) * std::cos(7 * v)});
    }
  for (uint32_t y = 0; y + 1 < row; ++y)
    for (uint32_t x = 0; x + 1 < row; ++x) {
      const uint32_t a = y * row + x, b = a + 1, c = a + row, d = c + 1;
      data.indices.insert(data.indices.end(), {a, b, d, a, d, c});
    }
  return test::makeMesh(data);
}

/// Distance from height 10 down to the surface at (x, y); infinity where there is none.
float depthAt(const World& world, float x, float y) {
  return test::shot(world, test::raysDown(x, y)).tFar[0];
}

size_t roomForAll() { return size_t{64} << 30; }
size_t roomForFull() { return (size_t{256} << 20) + size_t{230} * 2 * kRefinedSide * kRefinedSide; }
size_t hardlyAny() { return size_t{260} << 20; }
size_t g_free = 0;
size_t changing() { return g_free; }

struct Refinement : testing::Test {
  Arena arena{2};

  /// Updates with `snapshot` until a full structure is installed, for at most a minute; whether it was.
  bool awaitRefinement(World& world, const scene::Snapshot& snapshot) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (std::chrono::steady_clock::now() < deadline) {
      if (world.update(snapshot, arena).blasRefinements > 0) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return false;
  }
};

TEST_F(Refinement, FullStructureReplacesTheFastOne) {
  World world(0, roomForAll);
  const auto snapshot = test::makeSnapshot({wavySheet()});
  EXPECT_EQ(world.update(snapshot, arena).blasBuilds, 1u);
  const size_t fastBytes = world.bytes();
  World full(0, roomForAll);
  auto best = snapshot;
  best.settings.bvh = BvhQuality::full;
  full.update(best, arena);
  const float before = depthAt(world, 0.3f, -0.2f);
  ASSERT_TRUE(awaitRefinement(world, snapshot));
  EXPECT_LT(fastBytes, full.bytes());
  EXPECT_NEAR(static_cast<double>(world.bytes()), static_cast<double>(full.bytes()), 0.1 * full.bytes())
      << "the fast structure is still there, or none has come";
  EXPECT_NEAR(depthAt(world, 0.3f, -0.2f), before, 1e-5f);
  for (int frame = 0; frame < 20; ++frame) {
    const UpdateStatistics statistics = world.update(snapshot, arena);
    EXPECT_EQ(statistics.blasBuilds + statistics.blasRefinements + statistics.tlasBuilds, 0u);
  }
  EXPECT_EQ(world.cachedBlases(), 1u);
}

TEST_F(Refinement, FinishedStructureIsInstalledInTheNextFrame) {
  World world(0, roomForAll);
  const auto snapshot = test::makeSnapshot({wavySheet()});
  while (!world.refining()) ASSERT_EQ(world.update(snapshot, arena).blasRefinements, 0u);
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!world.refined()) {
    ASSERT_LT(std::chrono::steady_clock::now(), deadline);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  EXPECT_EQ(world.update(snapshot, arena).blasRefinements, 1u);
  EXPECT_FALSE(world.refined());
}

TEST_F(Refinement, InstancesUseTheFullStructure) {
  World world(0, roomForAll);
  const auto mesh = wavySheet();
  auto snapshot = test::makeSnapshot({mesh, mesh});
  snapshot.instances[1].worldFromObject[3] = {5, 0, 1, 1};
  world.update(snapshot, arena);
  const float before = depthAt(world, 5.3f, -0.2f);
  ASSERT_TRUE(awaitRefinement(world, snapshot));
  EXPECT_NEAR(depthAt(world, 5.3f, -0.2f), before, 1e-5f);
}

TEST_F(Refinement, SeveralMeshesAreRefinedOneByOne) {
  World world(0, roomForAll);
  const auto snapshot = test::makeSnapshot({wavySheet(0), wavySheet(1), wavySheet(2)});
  EXPECT_EQ(world.update(snapshot, arena).blasBuilds, 3u);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(awaitRefinement(world, snapshot)) << i;
}

TEST_F(Refinement, GeometryThatChangesIsNotBuiltTwice) {
  World world(0, roomForAll);
  for (int frame = 0; frame < 12; ++frame) {
    const UpdateStatistics statistics =
        world.update(test::makeSnapshot({wavySheet(static_cast<float>(frame))}), arena);
    EXPECT_EQ(statistics.blasBuilds, 1u);
    EXPECT_EQ(statistics.blasRefinements, 0u);
  }
}

TEST_F(Refinement, SmallGeometryIsBuiltOnce) {
  World world(0, roomForAll);
  const auto snapshot = test::makeSnapshot({wavySheet(0, 40)});
  world.update(snapshot, arena);
  const size_t bytes = world.bytes();
  for (int frame = 0; frame < 12; ++frame) EXPECT_EQ(world.update(snapshot, arena).blasRefinements, 0u);
  EXPECT_EQ(world.bytes(), bytes);
}

TEST_F(Refinement, UnusedMeshesAreNotRefined) {
  World world(0, roomForAll);
  const auto large = test::makeSnapshot({wavySheet(0, 700)}), other = test::makeSnapshot({wavySheet(0, 10)});
  for (int frame = 0; frame < 6; ++frame) world.update(large, arena);
  uint64_t refinements = 0;
  for (int frame = 0; frame < 40; ++frame) refinements += world.update(other, arena).blasRefinements;
  EXPECT_EQ(refinements, 0u);
  EXPECT_EQ(world.cachedBlases(), 1u);
  EXPECT_TRUE(std::isfinite(depthAt(world, 0.3f, -0.2f)));
}

TEST_F(Refinement, ScarceMemoryPreventsRefinement) {
  Arena alone{1};  // with several threads the memory that Embree takes depends on their timing
  auto snapshot = test::makeSnapshot({wavySheet()});
  const auto bytesOf = [&](BvhQuality quality) {
    World world;
    snapshot.settings.bvh = quality;
    world.update(snapshot, alone);
    return world.bytes();
  };
  const size_t runs = bytesOf(BvhQuality::fast), least = bytesOf(BvhQuality::least);
  snapshot.settings.bvh = BvhQuality::automatic;
  size_t bytes[2] = {};
  int i = 0;
  for (size_t (*const room)() : {roomForFull, hardlyAny}) {
    World world(0, room);
    world.update(snapshot, alone);
    bytes[i++] = world.bytes();
    for (int frame = 0; frame < 20; ++frame) EXPECT_EQ(world.update(snapshot, alone).blasRefinements, 0u);
  }
  EXPECT_EQ(bytes[0], runs);
  EXPECT_EQ(bytes[1], least) << "where runs do not fit";
  World fast(0, changing);
  g_free = roomForAll();
  fast.update(snapshot, alone);
  EXPECT_EQ(fast.bytes(), bytes[0]) << "runs, with room for better or without";
  g_free = hardlyAny();
  for (int frame = 0; frame < 20; ++frame) EXPECT_EQ(fast.update(snapshot, alone).blasRefinements, 0u);
}

TEST_F(Refinement, FailureKeepsTheFastStructure) {
  World world(0, roomForAll);
  const auto snapshot = test::makeSnapshot({wavySheet()});
  world.update(snapshot, arena);
  failNextCommits(1);
  for (int frame = 0; frame < 200; ++frame) {
    EXPECT_EQ(world.update(snapshot, arena).blasRefinements, 0u);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  failNextCommits(0);
  EXPECT_TRUE(std::isfinite(depthAt(world, 0.3f, -0.2f)));
}

TEST_F(Refinement, WorldMayBeDestroyedDuringABuild) {
  const size_t before = Device::bytes();
  for (int frames = 4; frames < 8; ++frames) {
    World world(0, roomForAll);
    const auto snapshot = test::makeSnapshot({wavySheet(0, 700)});
    for (int frame = 0; frame < frames; ++frame) world.update(snapshot, arena);
  }
  EXPECT_EQ(Device::bytes(), before);
}

}  // namespace
}  // namespace gluray::accel
