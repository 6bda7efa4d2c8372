// Instances that are hidden from kinds of rays, and the ground.
#include "accel/testing/test_scene.h"
#include "accel/world.h"
#include "scene/secondary_scene.h"

#include <gtest/gtest.h>

#include <limits>

namespace gluray::accel {
namespace {

/// Squares at z = 0, 1, 2; the last one is in the secondary scene.
scene::Snapshot squares() {
  scene::Snapshot s =
      test::makeSnapshot({test::makeMesh(test::squareData(0)), test::makeMesh(test::squareData(1)),
                          test::makeMesh(test::squareData(2))});
  s.settings.ao.enabled = true;
  auto around = std::make_shared<scene::SecondaryScene>();
  around->instances.push_back(s.instances.back());
  around->shadings = s.shadings;
  around->blended = {0};
  s.instances.pop_back();
  s.secondaryScene = around;
  return s;
}

/// From z = 5 downwards.
RayPacket packetDown() {
  RayPacket p{};
  for (int i = 0; i < kLanes; ++i) {
    p.orgX[i] = 0.1f, p.orgY[i] = 0.2f, p.orgZ[i] = 5, p.dirZ[i] = -1;
    p.tFar[i] = std::numeric_limits<float>::infinity();
    p.mask[i] = ~0u, p.geometry[i] = p.instance[i] = kNoHit;
  }
  return p;
}

struct Seen {
  uint32_t camera, reflection;
  bool shadow, occlusion;
};

Seen seenBy(const World& world) {
  alignas(64) const int32_t valid[kLanes] = {-1};
  RayPacket camera = packetDown(), bounced = packetDown();
  world.intersect(valid, camera);
  world.intersectBounced(valid, bounced);
  const auto blocked = [&](RayKind kind) {
    OcclusionRays rays{};
    rays.orgX[0] = 0.1f, rays.orgY[0] = 0.2f, rays.orgZ[0] = 1.5f, rays.dirZ[0] = 1, rays.tFar[0] = 10;
    return world.occluded(valid, rays, nullptr, kind) != 0;
  };
  return {camera.geometry[0] == kNoHit ? kNoHit : camera.instance[0],
          bounced.geometry[0] == kNoHit ? kNoHit : bounced.instance[0], blocked(RayKind::shadow),
          blocked(RayKind::occlusion)};
}

TEST(HiddenFrom, EachKindOfRayAloneMissesWhatIsHiddenFromIt) {
  World world;
  Arena arena(1);
  const scene::Snapshot s = squares();
  const auto seen = [&](const HiddenFrom& hidden) {
    world.update(s, arena, hidden);
    return seenBy(world);
  };
  Seen all = seen({});
  EXPECT_EQ(all.camera, 1u);
  EXPECT_EQ(all.reflection, 2u);
  EXPECT_TRUE(all.shadow && all.occlusion);
  Seen some = seen({0, bitOf(RayKind::camera), 0});
  EXPECT_EQ(some.camera, 0u) << "what lies behind is seen";
  EXPECT_EQ(some.reflection, 2u);
  some = seen({0, 0, bitOf(RayKind::reflection)});
  EXPECT_EQ(some.reflection, 1u);
  EXPECT_TRUE(some.shadow && some.occlusion);
  some = seen({0, 0, bitOf(RayKind::shadow)});
  EXPECT_TRUE(!some.shadow && some.occlusion && some.reflection == 2);
  some = seen({0, 0, bitOf(RayKind::occlusion)});
  EXPECT_TRUE(some.shadow && !some.occlusion && some.reflection == 2);
  some = seen({15, 15, 15});
  EXPECT_TRUE(some.camera == kNoHit && some.reflection == kNoHit && !some.shadow && !some.occlusion);
  all = seen({});
  EXPECT_TRUE(all.camera == 1 && all.reflection == 2 && all.shadow && all.occlusion) << "and back";
}

TEST(HiddenFrom, NoStructureOfAMeshIsRebuilt) {
  World world;
  Arena arena(1);
  scene::Snapshot s = squares();
  EXPECT_EQ(world.update(s, arena).blasBuilds, 3u);
  for (uint8_t bits = 0; bits < 16; ++bits) {
    ++s.frame;
    EXPECT_EQ(world.update(s, arena, {bits, 0, bits}).blasBuilds, 0u);
  }
}

TEST(HiddenFrom, BatchesWithoutAnythingToSeeLeaveCoincidenceUnchanged) {
  World world;
  Arena arena(1);
  const auto square = test::makeMesh(test::squareData());
  const scene::Snapshot twice = test::makeSnapshot({square, square}), once = test::makeSnapshot({square});
  const scene::Snapshot apart = test::makeSnapshot({square, test::makeMesh(test::squareData(1))});
  for (const scene::Snapshot& unseen : {once, apart}) {
    world.update(twice, arena);
    EXPECT_TRUE(world.mayCoincide());
    world.update(unseen, arena, HiddenFrom(unseen.instances.size(), bitOf(RayKind::camera)));
    EXPECT_TRUE(world.empty());
    EXPECT_FALSE(world.mayCoincide());
    EXPECT_EQ(world.update(twice, arena).tlasBuilds, 0u);
    EXPECT_TRUE(world.mayCoincide());
  }
}

TEST(HiddenFrom, BoundsOfLightStay) {
  World world;
  Arena arena(1);
  const scene::Snapshot s = squares();
  world.update(s, arena);
  const Bounds before = world.lightBounds();
  world.update(s, arena, {0, 15, 15});
  EXPECT_EQ(world.lightBounds().lower, before.lower);
  EXPECT_EQ(world.lightBounds().upper, before.upper);
}

/// The squares and a ground at z = -1; the viewer looks along -z in parallel.
scene::Snapshot grounded() {
  scene::Snapshot s = squares();
  auto mesh = test::makeMesh(test::quadData({-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0}));
  mesh->lower = {-4, -4, 0}, mesh->upper = {4, 4, 0};
  scene::Instance ground = s.instances[0];
  ground.mesh = mesh;
  ground.worldFromObject[3].z = -1, ground.eyeFromObject[3].z = -1;
  ground.ground = true;
  s.ground = scene::GroundUse::drawn;
  s.instances.push_back(ground);
  return s;
}

TEST(Ground, IsMetBeyondTheEndOfTheViewersRaysAndCountsForNoBounds) {
  World world;
  Arena arena(1);
  const scene::Snapshot s = grounded();
  world.update(s, arena);
  alignas(64) const int32_t valid[kLanes] = {-1, -1, -1, -1};
  RayPacket p = packetDown();
  for (int i = 0; i < 4; ++i) p.tFar[i] = 5.5f;  // before the ground, at 6
  p.orgX[1] = 3, p.orgX[2] = 5;
  p.orgX[3] = 3, p.tNear[3] = 7;
  world.intersect(valid, p);
  EXPECT_EQ(p.instance[0], 1u) << "surfaces before it hide it";
  EXPECT_EQ(p.instance[1], 2u);
  EXPECT_FLOAT_EQ(p.tFar[1], 6);
  const scene::Mesh& mesh = *s.instances[2].mesh;
  const auto corner = [&](uint32_t k) { return mesh.position(mesh.corner(p.primitive[1], k)); };
  const glm::vec3 at = corner(0) * (1 - p.u[1] - p.v[1]) + corner(1) * p.u[1] + corner(2) * p.v[1];
  EXPECT_NEAR(at.x, 3, 1e-5);
  EXPECT_NEAR(at.y, 0.2f, 1e-5);
  EXPECT_EQ(p.geometry[2], kNoHit) << "beside it";
  EXPECT_EQ(p.geometry[3], kNoHit) << "behind it";
  const Bounds bounds = world.lightBounds();
  EXPECT_EQ(bounds.lower, glm::vec3(-1, -1, 0));
  EXPECT_EQ(bounds.upper, glm::vec3(1, 1, 2));
  EXPECT_EQ(world.seenBounds().lower, glm::vec3(-4, -4, -1));
  RayPacket bounced = packetDown();
  bounced.orgX[0] = 3;
  world.intersectBounced(valid, bounced);
  EXPECT_EQ(bounced.instance[0], 2u);
  EXPECT_FLOAT_EQ(bounced.tFar[0], 6);
}

}  // namespace
}  // namespace gluray::accel
