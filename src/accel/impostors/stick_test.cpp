// Sticks by packets of rays, as solids for single rays, and as shading sees them: three computations, one
// answer.
#include "accel/impostors/stick.h"

#include "accel/impostors/solid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace gluray::accel {
namespace {

using End = Stick::End;
constexpr float kNoLimit = std::numeric_limits<float>::infinity();

uint32_t bitsOf(End end) {
  return end == End::open ? 0u : scene::kClosedEnd | (end == End::round ? scene::kRoundEnd : 0u);
}

/// A stick from `a` to `b` in lighting space.
struct StickStage {
  std::shared_ptr<scene::Mesh> mesh = std::make_shared<scene::Mesh>();
  std::vector<glm::vec3> positions;
  std::vector<uint32_t> ends;
  PlacedImpostors placed;

  StickStage(const glm::vec3& a, const glm::vec3& b, float radius, End first, End second)
      : positions{a, b, {}, {}}, ends{bitsOf(first), bitsOf(second)} {
    mesh->shape = scene::Shape::sticks;
    mesh->triangleCount = 1, mesh->vertexCount = 2, mesh->radius = radius;
    mesh->positions = {nullptr, reinterpret_cast<const std::byte*>(positions.data()), 12,
                       scene::Format::float3};
    mesh->ends = {nullptr, reinterpret_cast<const std::byte*>(ends.data()), 4, scene::Format::uint32};
    placed.mesh = mesh;
  }
  Stick stick() const {
    Stick s;
    EXPECT_TRUE(Stick::make(placed, 0, s));
    return s;
  }
  uint32_t meet(const glm::vec3& org, const glm::vec3& dir, float& t) const {
    ImpostorRays rays;
    for (int i = 0; i < kLanes; ++i) {
      for (int c = 0; c < 3; ++c) rays.org[c][i] = org[c], rays.dir[c][i] = dir[c];
      rays.inverseLength[i] = 1 / glm::length(dir), rays.eye[i] = 0, rays.tFar[i] = 1e30f;
    }
    alignas(64) float all[kLanes];
    const uint32_t met = accel::meet(stick(), rays, 0xFFFFu, all);
    EXPECT_TRUE(met == 0 || met == 0xFFFFu);
    t = all[0];
    return met;
  }
  std::optional<SolidHit> solid(const glm::vec3& org, const glm::vec3& dir) const {
    return meetSolid(placed, 0, {org, dir, 0, kNoLimit});
  }
};

glm::vec3 inCube(std::mt19937& random, float half) {
  std::uniform_real_distribution<float> within(-half, half);
  const float x = within(random), y = within(random), z = within(random);
  return {x, y, z};
}

TEST(Sticks, PacketsMeetWhatSingleRaysMeet) {
  std::mt19937 random(7);
  int hits = 0, doubtful = 0;
  for (int i = 0; i < 20000; ++i) {
    const glm::vec3 a = inCube(random, 1) - glm::vec3(0, 0, 4), b = inCube(random, 1) - glm::vec3(0, 0, 4);
    const End kinds[] = {End::flat, End::round};
    const StickStage stage(a, b, 0.05f + 0.001f * static_cast<float>(i % 300), kinds[i % 2],
                           kinds[i / 2 % 2]);
    const glm::vec3 org = inCube(random, 0.5f), dir = inCube(random, 1) - glm::vec3(0, 0, 4) - org;
    float t = 0;
    const uint32_t met = stage.meet(org, dir, t);
    const auto solid = stage.solid(org, dir);
    if (solid.has_value() != (met != 0)) {
      ++doubtful;  // at silhouettes
      continue;
    }
    if (!met) continue;
    ++hits;
    ASSERT_NEAR(t, solid->t, 2e-3f * solid->t);
    const StickPoint seen = see(stage.stick(), glm::dvec3(org), glm::normalize(glm::dvec3(dir)));
    const glm::dvec3 point = glm::dvec3(org) + double{solid->t} * glm::dvec3(dir);
    ASSERT_LT(glm::distance(seen.point, point), 1e-4) << i;
    ASSERT_LT(glm::distance(seen.normal, glm::normalize(solid->normal)), 2e-2f) << i;
    ASSERT_GE(seen.share, 0);
    ASSERT_LE(seen.share, 1);
  }
  EXPECT_GT(hits, 2000);
  EXPECT_LT(doubtful, 20);
}

/// From z = 5 downwards along a line at `x`, on a stick from z = 0 to z = 1 of radius 0.5 that leans to +x.
TEST(Sticks, EndsAreOpenFlatOrRound) {
  const glm::vec3 down(0, 0, -1);
  float t = 0;
  const glm::vec3 low(0, 0, 0), high(0.1f, 0, 1);
  const auto seenBy = [&](End top, float x) {
    return StickStage(low, high, 0.5f, End::flat, top).meet({x, 0, 5}, down, t) != 0;
  };
  EXPECT_FALSE(seenBy(End::open, 0.1f));
  EXPECT_TRUE(seenBy(End::flat, 0.1f));
  EXPECT_NEAR(t, 4, 1e-5f);
  EXPECT_TRUE(seenBy(End::round, 0.1f));
  EXPECT_NEAR(t, 3.5f, 1e-5f);
  EXPECT_FALSE(seenBy(End::round, 1.2f));
  // Beside the end, but on the mantle that leans away from the ray's line.
  EXPECT_TRUE(StickStage(low, {1, 0, 1}, 0.5f, End::open, End::open).meet({0.2f, 0, 5}, down, t));
  // Open ends stop other rays.
  EXPECT_TRUE(StickStage(low, high, 0.5f, End::flat, End::open).solid({0.1f, 0, 5}, down));
}

TEST(Sticks, AreNotSeenWhereTheyBeginBeforeTheRay) {
  const StickStage stage({0, 0, 0}, {1, 0, 0}, 0.5f, End::flat, End::flat);
  float t = 0;
  EXPECT_TRUE(stage.meet({0.5f, 0, 0.6f}, {0, 0, -1}, t));
  EXPECT_FALSE(stage.meet({0.5f, 0, 0.2f}, {0, 0, -1}, t));
  EXPECT_FALSE(stage.meet({0.5f, 0, -0.6f}, {0, 0, -1}, t));
  const auto from = stage.solid({0.5f, 0, 0.2f}, {0, 0, -1});  // others meet it from within
  ASSERT_TRUE(from);
  EXPECT_NEAR(from->t, 0.7f, 1e-6f);
}

TEST(Sticks, WithoutLengthDoNotExist) {
  Stick s;
  EXPECT_FALSE(Stick::make(StickStage({1, 2, 3}, {1, 2, 3}, 1, End::flat, End::flat).placed, 0, s));
  EXPECT_FALSE(Stick::make(StickStage({1, 2, 3}, {1, 2, 4}, 0, End::flat, End::flat).placed, 0, s));
  EXPECT_FALSE(StickStage({1, 2, 3}, {1, 2, 3}, 1, End::flat, End::round).solid({1, 2, 9}, {0, 0, -1}));
}

TEST(Sticks, RoundEndsAreFlatWhereTheProgramSaysSo) {
  StickStage stage({0, 0, 0}, {0, 0, 1}, 0.5f, End::round, End::round);
  EXPECT_EQ(stage.stick().ends[1], End::round);
  stage.placed.look.roundEnds = false;
  EXPECT_EQ(stage.stick().ends[1], End::flat);
}

}  // namespace
}  // namespace gluray::accel
