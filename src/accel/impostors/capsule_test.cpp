// Capsules by packets of rays, as solids for single rays, and as shading sees them: three computations, one
// answer.
#include "accel/impostors/capsule.h"

#include "accel/impostors/solid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace gluray::accel {
namespace {

/// A line from `a` to `b` in lighting space, whose radius grows with the distance from the plane z = 0.
struct Stage {
  std::shared_ptr<scene::Mesh> mesh = std::make_shared<scene::Mesh>();
  std::vector<glm::vec3> positions;
  PlacedImpostors placed;

  Stage(const glm::vec3& a, const glm::vec3& b, float radius, float perDepth = 0) : positions{a, b} {
    positions.emplace_back(0);  // readable bytes after the last
    positions.emplace_back(0);
    mesh->shape = scene::Shape::capsules;
    mesh->triangleCount = 1, mesh->vertexCount = 2;
    mesh->positions = {nullptr, reinterpret_cast<const std::byte*>(positions.data()), 12,
                       scene::Format::float3};
    placed.mesh = mesh;
    placed.look.radius = radius;
    placed.objectW = {0, 0, -1, 0}, placed.objectNear = {0, 0, -1, -0.1f};
    placed.halfWidthPerW = perDepth;
    placed.viewer = {0, 0, 0, 1};
  }
  Capsule capsule() const {
    Capsule c;
    EXPECT_TRUE(Capsule::make(placed, 0, c));
    return c;
  }
};

ImpostorRays allLanes(const glm::vec3& org, const glm::vec3& dir) {
  ImpostorRays rays;
  for (int i = 0; i < kLanes; ++i) {
    for (int c = 0; c < 3; ++c) rays.org[c][i] = org[c], rays.dir[c][i] = dir[c];
    rays.inverseLength[i] = 1 / glm::length(dir), rays.eye[i] = 0, rays.tFar[i] = 1e30f;
  }
  return rays;
}

glm::vec3 inBox(std::mt19937& random, float half) {
  std::uniform_real_distribution<float> within(-half, half);
  const float x = within(random), y = within(random), z = within(random);
  return {x, y, z};
}

TEST(Capsules, PacketsMeetWhatSingleRaysMeet) {
  std::mt19937 random(7);
  int hits = 0, doubtful = 0;
  for (int i = 0; i < 20000; ++i) {
    const glm::vec3 a = inBox(random, 1) - glm::vec3(0, 0, 4), b = inBox(random, 1) - glm::vec3(0, 0, 4);
    const bool pixels = i % 2 == 0;
    const Stage stage(a, b, pixels ? 0.0f : 0.05f + 0.001f * static_cast<float>(i % 300), 0.04f);
    const glm::vec3 org = inBox(random, 0.5f), dir = inBox(random, 1) - glm::vec3(0, 0, 4) - org;
    alignas(64) float t[kLanes];
    const uint32_t met = meet(stage.placed, stage.capsule(), allLanes(org, dir), 0xFFFFu, t);
    EXPECT_TRUE(met == 0 || met == 0xFFFFu);
    const auto solid = meetSolid(stage.placed, 0, {org, dir, 0, std::numeric_limits<float>::infinity()});
    if (solid.has_value() != (met != 0)) {
      ++doubtful;  // at silhouettes
      continue;
    }
    if (!met) continue;
    ++hits;
    ASSERT_NEAR(t[0], solid->t, 2e-3f * solid->t);
    const CapsulePoint seen = see(stage.capsule(), glm::dvec3(org), glm::normalize(glm::dvec3(dir)));
    const glm::dvec3 point = glm::dvec3(org) + double{solid->t} * glm::dvec3(dir);
    ASSERT_LT(glm::distance(seen.point, point), 1e-4);
    ASSERT_LT(glm::distance(seen.normal, glm::normalize(solid->normal)), 2e-2f);
    ASSERT_GE(seen.share, -1e-5f);
    ASSERT_LE(seen.share, 1 + 1e-5f);
  }
  EXPECT_GT(hits, 1500);
  EXPECT_LT(doubtful, 10);
}

TEST(Capsules, ShareRunsAlongTheLine) {
  const Stage stage({-1, 0, -4}, {1, 0, -4}, 0.1f);
  for (const double x : {-1.0, -0.5, 0.0, 0.75, 1.0}) {
    const CapsulePoint seen = see(stage.capsule(), {x, 0, 0}, {0, 0, -1});
    EXPECT_NEAR(seen.share, 0.5 + 0.5 * x, 1e-5);
    EXPECT_NEAR(seen.point.z, -3.9, 1e-6);
    EXPECT_NEAR(seen.cosine, 1, 1e-6);
  }
}

TEST(Capsules, LongThinLinesKeepTheirWidth) {
  const Stage stage({-1000, 0, -4}, {1000, 0, -4}, 0.01f);
  for (const float y : {0.0099f, -0.0099f, 0.0101f, -0.0101f}) {
    alignas(64) float t[kLanes];
    const uint32_t met = meet(stage.placed, stage.capsule(), allLanes({700, y, 0}, {0, 0, -1}), 0xFFFFu, t);
    EXPECT_EQ(met != 0, std::abs(y) < 0.01f);
  }
}

TEST(Capsules, ThatHoldTheViewerAreInvisible) {
  const Stage stage({-1, 0, 0.05f}, {1, 0, 0.05f}, 0.3f);
  alignas(64) float t[kLanes];
  EXPECT_EQ(meet(stage.placed, stage.capsule(), allLanes({0, 0, -0.1f}, {0, 0, -1}), 0xFFFFu, t), 0u);
}

TEST(Capsules, ThatReachThroughTheNearPlaneBeginThere) {
  const Stage stage({-1, 0, -1}, {1, 0, -1}, 0.5f);
  alignas(64) float t[kLanes];
  EXPECT_EQ(meet(stage.placed, stage.capsule(), allLanes({0, 0, -0.8f}, {0, 0, -1}), 0xFFFFu, t), 0xFFFFu);
  EXPECT_EQ(t[0], 0);
}

TEST(Capsules, PlanesCutTheLine) {
  Stage stage({-1, 0, -4}, {1, 0, -4}, 0.1f);
  stage.placed.look.centerPlanes = {{1, 0, 0, 0}};
  const Capsule cut = stage.capsule();
  EXPECT_NEAR(cut.end[0].x, 0, 1e-6);
  EXPECT_NEAR(cut.share[0], 0.5, 1e-6);
  stage.placed.look.centerPlanes = {{1, 0, 0, -2}};
  Capsule none;
  EXPECT_FALSE(Capsule::make(stage.placed, 0, none));
}

TEST(Capsules, WithoutLengthDoNotExist) {
  const Stage stage({1, 0, -4}, {1, 0, -4}, 0.1f);
  Capsule none;
  EXPECT_FALSE(Capsule::make(stage.placed, 0, none));
}

}  // namespace
}  // namespace gluray::accel
