// Which structures stay in memory with those that rays are traced in.
#include "accel/testing/test_rays.h"
#include "accel/testing/test_scene.h"
#include "accel/world.h"

#include <gtest/gtest.h>

namespace gluray::accel {
namespace {

struct WorldMemory : testing::Test {
  static constexpr size_t kLarge = size_t{1} << 20;
  Arena arena{2};
  World world{0};  // keeps nothing that is not used
  scene::Snapshot lone = test::makeSnapshot({test::makeMesh(test::squareData(3))});
  scene::Snapshot two;
  size_t few = 0;  // bytes with `lone` alone

  WorldMemory() {
    const auto mesh = test::scatteredTriangles(30000);
    two = test::makeSnapshot({mesh, mesh});
    two.instances[1].worldFromObject[3].x = two.instances[1].eyeFromObject[3].x = 5;
    draw(lone, 1);
    few = world.bytes();
  }
  UpdateStatistics draw(scene::Snapshot& snapshot, uint64_t frame) {
    snapshot.frame = frame;
    return world.update(snapshot, arena);
  }
};

TEST_F(WorldMemory, InstancesThatAreDrawnNoMoreAreFreed) {
  for (uint64_t frame = 2; frame < 20; frame += 6) {
    EXPECT_EQ(draw(two, frame).tlasBuilds, 1u);
    EXPECT_GT(world.bytes(), few + kLarge);
    for (uint64_t after = 1; after < 4; ++after) draw(lone, frame + after);
    EXPECT_EQ(world.cachedBlases(), 1u);
    EXPECT_LT(world.bytes(), few + kLarge / 8);
    EXPECT_NE(test::shot(world, test::raysDown(0.3f, 0.2f)).geometry[0], kNoHit);
  }
}

TEST_F(WorldMemory, InstancesAreFreedWhereNothingElseIsDrawn) {
  scene::Snapshot none = test::makeSnapshot({});
  draw(two, 2), draw(none, 3), draw(none, 4);
  EXPECT_TRUE(world.empty());
  EXPECT_LT(world.bytes(), few + kLarge / 8);
  EXPECT_EQ(draw(two, 5).tlasBuilds, 1u);
  EXPECT_FALSE(world.empty());
}

TEST_F(WorldMemory, BatchesThatTakeTurnsInAFrameKeepTheTopLevel) {
  World roomy;
  for (uint64_t frame = 2; frame < 10; ++frame)
    for (scene::Snapshot* batch : {&lone, &two, &lone}) {
      batch->frame = frame;
      const uint64_t builds = roomy.update(*batch, arena).tlasBuilds;
      EXPECT_EQ(builds, frame == 2 && batch == &two ? 1u : 0u);
    }
}

TEST_F(WorldMemory, LightLetsSecondaryScenesGoThatAreDrawnNoMore) {
  two.settings.ao.enabled = lone.settings.ao.enabled = true;
  const HiddenFrom hidden = {0, bitOf(RayKind::shadow)};
  two.frame = 2;
  world.update(two, arena, hidden);
  for (uint64_t frame = 3; frame < 6; ++frame) draw(lone, frame);
  EXPECT_LT(world.bytes(), few + kLarge / 8);
}

// The structures of the last update are given back before the next attempt.
TEST_F(WorldMemory, WhatWasTracedLastIsFreedWhereMemoryHasRunOut) {
  for (const bool alone : {false, true}) {
    scene::Snapshot last = two;
    if (alone) last.instances.pop_back();
    draw(last, 2);
    failNextCommits(1);
    EXPECT_EQ(draw(lone, 2).blasBuilds, 1u);
    EXPECT_EQ(commitsStillToFail(), 0);
    EXPECT_LT(world.bytes(), few + kLarge / 8);
    EXPECT_NE(test::shot(world, test::raysDown(0.3f, 0.2f)).geometry[0], kNoHit);
  }
}

TEST_F(WorldMemory, NothingIsTracedAfterAnUpdateThatMemoryDidNotSufficeFor) {
  draw(two, 2);
  failNextCommits(3);
  EXPECT_THROW(draw(lone, 2), std::exception);
  failNextCommits(0);
  EXPECT_TRUE(world.empty());
  EXPECT_LT(world.bytes(), few + kLarge / 8);
  EXPECT_EQ(draw(two, 2).tlasBuilds, 1u);
  EXPECT_NE(
      test::shot(world, test::raysDown(5 + std::sin(7.0f) + 0.001f, std::cos(11.0f) + 0.001f)).geometry[0],
      kNoHit);
}

}  // namespace
}  // namespace gluray::accel
