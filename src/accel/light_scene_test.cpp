// Light meets the secondary scene of a snapshot as if its instances were the snapshot's own; the viewer's
// rays do not.
#include "accel/light_scene.h"

#include "accel/testing/test_scene.h"
#include "accel/world.h"
#include "scene/secondary_scene.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

namespace gluray::accel {
namespace {

using test::kInfinity;

/// Many triangles about the origin; others for each seed.
scene::MeshPtr soup(uint32_t seed) {
  test::MeshData data;
  const auto at = [&](uint32_t i) {
    const auto part = [&](uint32_t k) {
      uint32_t h = (i * 3 + k) * 2654435761u + seed * 40503u;
      h ^= h >> 15, h *= 2246822519u, h ^= h >> 13;
      return static_cast<float>(h % 20001) / 10000 - 1;
    };
    return glm::vec3(part(0), part(1), part(2));
  };
  for (uint32_t t = 0; t < 200; ++t)
    for (uint32_t k = 0; k < 3; ++k) data.positions.push_back(at(7 * t) + 0.2f * at(7 * t + k + 1));
  return test::makeMesh(data);
}

scene::MeshPtr spheres() {
  auto mesh = std::make_shared<scene::Mesh>();
  mesh->shape = scene::Shape::spheres;
  mesh->vertexCount = mesh->triangleCount = 3;
  mesh->positions =
      test::makeAttribute<glm::vec3>({{-1, 0, 0}, {0.5f, 1, 0}, {0, -1, 0.5f}}, scene::Format::float3);
  mesh->radius = 0.3f;
  mesh->lower = glm::vec3(-2), mesh->upper = glm::vec3(2);
  return mesh;
}

const glm::mat4 kPlace = glm::rotate(glm::translate(glm::mat4(1), {0.5f, 0.2f, 0}), 0.7f, {1, 2, 3});

/// All in one snapshot, the last `around` of them as its secondary scene.
scene::Snapshot sceneOf(const std::vector<scene::MeshPtr>& meshes, size_t around) {
  scene::Snapshot s = test::makeSnapshot(meshes);
  for (size_t i = 1; i < s.instances.size(); i += 2) {
    s.instances[i].worldFromObject = kPlace;
    s.instances[i].eyeFromObject = glm::dmat4(kPlace);
    s.instances[i].lightingFromObject = kPlace;
  }
  if (around == 0) return s;
  auto others = std::make_shared<scene::SecondaryScene>();
  const auto first = s.instances.end() - static_cast<std::ptrdiff_t>(around);
  others->instances.assign(first, s.instances.end());
  others->shadings = s.shadings;
  others->blended.assign(around, 0);
  s.instances.erase(first, s.instances.end());
  s.secondaryScene = others;
  return s;
}

OcclusionRays raysOf(uint32_t packet) {
  OcclusionRays rays{};
  for (int i = 0; i < kLanes; ++i) {
    const float a = 0.37f * static_cast<float>(packet * kLanes + static_cast<uint32_t>(i)), b = 1.7f * a;
    rays.orgX[i] = 2 * std::cos(a) * std::cos(b), rays.orgY[i] = 2 * std::sin(a) * std::cos(b),
    rays.orgZ[i] = 2 * std::sin(b);
    rays.dirX[i] = 0.3f * std::sin(3 * a) - rays.orgX[i],
    rays.dirY[i] = 0.3f * std::cos(5 * a) - rays.orgY[i],
    rays.dirZ[i] = 0.3f * std::sin(7 * a) - rays.orgZ[i];
    rays.tFar[i] = 0.7f;
  }
  return rays;
}

RayPacket bouncedPacket(const OcclusionRays& rays) {
  RayPacket p{};
  for (int i = 0; i < kLanes; ++i) {
    p.orgX[i] = rays.orgX[i], p.orgY[i] = rays.orgY[i], p.orgZ[i] = rays.orgZ[i];
    p.dirX[i] = rays.dirX[i], p.dirY[i] = rays.dirY[i], p.dirZ[i] = rays.dirZ[i];
    p.tFar[i] = kInfinity, p.mask[i] = ~0u, p.id[i] = static_cast<uint32_t>(i);
    p.geometry[i] = p.instance[i] = kNoHit;
  }
  return p;
}

class Surrounded : public testing::TestWithParam<size_t> {
 protected:
  alignas(64) int32_t all_[kLanes] = {-1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1};
  Arena arena_{2};
};

TEST_P(Surrounded, LightMeetsWhatOneSnapshotOfAllWouldHold) {
  const std::vector<scene::MeshPtr> meshes = {soup(1), soup(2), spheres(), soup(3), spheres()};
  World whole, split;
  whole.update(sceneOf(meshes, 0), arena_);
  split.update(sceneOf(meshes, GetParam()), arena_);
  EXPECT_EQ(split.lightBounds().lower, whole.lower());
  EXPECT_EQ(split.lightBounds().upper, whole.upper());
  int blocked = 0, met = 0;
  for (uint32_t n = 0; n < 100; ++n) {
    OcclusionRays one = raysOf(n), other = raysOf(n);
    const uint32_t expected = whole.occluded(all_, one);
    ASSERT_EQ(split.occluded(all_, other), expected) << "packet " << n;
    blocked += std::popcount(expected);
    RayPacket a = bouncedPacket(raysOf(n)), b = bouncedPacket(raysOf(n));
    whole.intersectBounced(all_, a), split.intersectBounced(all_, b);
    for (int i = 0; i < kLanes; ++i) {
      ASSERT_EQ(a.tFar[i], b.tFar[i]);
      if (a.geometry[i] == kNoHit) continue;
      ASSERT_EQ(a.instance[i], b.instance[i]);
      ASSERT_EQ(a.primitive[i], b.primitive[i]);
      met += b.instance[i] >= meshes.size() - GetParam();
    }
  }
  EXPECT_GT(blocked, 200);
  EXPECT_LT(blocked, 1500);
  EXPECT_GT(met, 20);
}

INSTANTIATE_TEST_SUITE_P(Numbers, Surrounded, testing::Values(1, 2, 3, 4));

TEST_F(Surrounded, TheViewersRaysMeetTheSnapshotAlone) {
  const std::vector<scene::MeshPtr> meshes = {soup(1), soup(2), spheres()};
  World alone, split;
  alone.update(sceneOf({meshes[0]}, 0), arena_);
  split.update(sceneOf(meshes, 2), arena_);
  EXPECT_FALSE(split.hasImpostors());
  EXPECT_EQ(split.lower(), alone.lower());
  EXPECT_EQ(split.upper(), alone.upper());
  for (uint32_t n = 0; n < 50; ++n) {
    RayPacket a = bouncedPacket(raysOf(n)), b = bouncedPacket(raysOf(n));
    alone.intersect(all_, a), split.intersect(all_, b);
    for (int i = 0; i < kLanes; ++i) {
      ASSERT_EQ(a.tFar[i], b.tFar[i]);
      ASSERT_EQ(a.geometry[i], b.geometry[i]);
    }
  }
}

TEST_F(Surrounded, NoMeshIsBuiltAgainForLight) {
  World world;
  const scene::MeshPtr one = soup(1), other = soup(2);
  EXPECT_EQ(world.update(sceneOf({one}, 0), arena_).blasBuilds, 1u);
  EXPECT_EQ(world.update(sceneOf({other}, 0), arena_).blasBuilds, 1u);
  for (int i = 0; i < 30; ++i) {
    EXPECT_EQ(world.update(sceneOf({one, other}, 1), arena_).blasBuilds, 0u);
    EXPECT_EQ(world.update(sceneOf({other, one}, 1), arena_).blasBuilds, 0u);
  }
}

TEST_F(Surrounded, WhatSurroundsIsNotFreed) {
  World world(0);  // keeps nothing that is not used
  const scene::MeshPtr one = soup(1), other = soup(2);
  world.update(sceneOf({one, other}, 1), arena_);
  EXPECT_EQ(world.cachedBlases(), 2u);
  EXPECT_EQ(world.update(sceneOf({one, other}, 1), arena_).blasBuilds, 0u);
  world.update(sceneOf({one}, 0), arena_);
  EXPECT_EQ(world.cachedBlases(), 1u);
}

TEST_F(Surrounded, WhatCannotBePlacedIsLeftOut) {
  scene::Snapshot s = sceneOf({soup(1), soup(2), soup(3)}, 2);
  auto around = std::make_shared<scene::SecondaryScene>(*s.secondaryScene);
  around->instances[0].worldFromObject = glm::mat4(0);
  s.secondaryScene = around;
  World world, without;
  world.update(s, arena_);
  without.update(sceneOf({soup(1), std::make_shared<scene::Mesh>(), soup(3)}, 2), arena_);
  for (uint32_t n = 0; n < 50; ++n) {
    OcclusionRays one = raysOf(n), other = raysOf(n);
    ASSERT_EQ(world.occluded(all_, one), without.occluded(all_, other));
  }
}

TEST_F(Surrounded, BoundsAreThoseInTheViewsWorld) {
  scene::Snapshot s = sceneOf({soup(1), soup(2)}, 1);
  auto around = std::make_shared<scene::SecondaryScene>(*s.secondaryScene);
  around->viewFromWorld = glm::translate(glm::dmat4(1), {10, 0, 0});
  World here, moved;
  here.update(s, arena_);
  s.secondaryScene = around;
  moved.update(s, arena_);
  EXPECT_NEAR(moved.lightBounds().lower.x, here.lightBounds().lower.x + 10, 1e-4f);
  EXPECT_NEAR(moved.lightBounds().upper.z, here.lightBounds().upper.z, 1e-4f);
}

}  // namespace
}  // namespace gluray::accel
