// Half spheres that are seen along -z from everywhere (scene/impostors.h, `hemispheres`), against closed
// forms.
#include "accel/impostors/placed_impostors.h"
#include "accel/impostors/solid.h"
#include "accel/impostors/solid_guess.h"
#include "accel/testing/test_scene.h"
#include "accel/world.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gluray::accel {
namespace {

/// Seen at 80 degrees between planes at 0.5 and 50.
struct Hemispheres : testing::Test {
  Arena arena{2};
  World world;
  std::vector<glm::vec3> centers;
  std::vector<float> radii;

  scene::Snapshot snapshot() const {
    auto mesh = std::make_shared<scene::Mesh>();
    mesh->shape = scene::Shape::spheres;
    mesh->triangleCount = mesh->vertexCount = static_cast<uint32_t>(centers.size());
    mesh->positions = test::makeAttribute(centers, scene::Format::float3);
    mesh->radii = test::makeAttribute(radii, scene::Format::float1);
    mesh->geometryId = hashBytes(centers.data(), centers.size() * sizeof(glm::vec3));
    scene::Snapshot s = test::makeSnapshot({mesh});
    s.camera.clipFromEye = glm::perspective(glm::radians(80.0), 1.0, 0.5, 50.0);
    s.instances[0].impostors.billboards = scene::Impostors::Billboards::square;
    s.instances[0].impostors.hemispheres = true;
    return s;
  }
  void addMany() {
    for (int i = 0; i < 60; ++i) {
      const auto t = static_cast<float>(i);
      centers.push_back({4 * std::sin(1.7f * t), 4 * std::sin(2.3f * t + 1), -6 + 2 * std::cos(0.9f * t)});
      radii.push_back(0.7f + 0.4f * std::sin(5 * t));
    }
  }
  /// Distance along `dir`, whose z is -1, or infinity.
  double expected(uint32_t k, const glm::dvec3& dir) const {
    const glm::dvec3 c(centers[k]), from = dir * -c.z - c;
    const double r = radii[k], open = r * r - from.x * from.x - from.y * from.y;
    if (open <= 0 || -(c.z + r) <= 0.5 || -c.z >= 50) return std::numeric_limits<double>::infinity();
    return -(c.z + std::sqrt(open));
  }
  /// The primitive that a ray from the viewer hits, and its t.
  std::pair<uint32_t, float> shoot(const glm::vec3& dir, int lane) const {
    RayPacket packet{};
    PixelRays rays{};
    alignas(64) int32_t valid[kLanes] = {};
    for (int i = 0; i < kLanes; ++i) {
      packet.dirX[i] = rays.dirX[i] = dir.x, packet.dirY[i] = rays.dirY[i] = dir.y;
      packet.dirZ[i] = rays.dirZ[i] = dir.z, packet.tFar[i] = rays.tFar[i] = 50;
      packet.mask[i] = ~0u, packet.geometry[i] = packet.instance[i] = kNoHit;
      packet.id[i] = static_cast<uint32_t>(i);
    }
    valid[lane] = -1;
    const ImpostorQuery query{&rays, &rays};
    world.intersect(valid, packet, nullptr, &query);
    if (packet.geometry[lane] == kNoHit) return {kNoHit, 0.0f};
    return {packet.primitive[lane], packet.tFar[lane]};
  }
};

glm::dvec3 wayOf(int i) { return {0.83 * std::sin(1.3 * i), 0.83 * std::cos(0.7 * i), -1}; }

TEST_F(Hemispheres, HitsAreNearestAndMatchTheEquation) {
  addMany();
  world.update(snapshot(), arena);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const glm::vec3 dir(wayOf(i));
    double nearest = std::numeric_limits<double>::infinity();
    uint32_t which = kNoHit;
    for (uint32_t k = 0; k < centers.size(); ++k)
      if (const double t = expected(k, dir); t < nearest) nearest = t, which = k;
    const auto [primitive, t] = shoot(dir, i % kLanes);
    ASSERT_EQ(primitive, which) << i;
    if (which == kNoHit) continue;
    ++hits;
    ASSERT_NEAR(t, nearest, 2e-5) << i;
  }
  EXPECT_GT(hits, 500);
}

// Embree drops boxes behind the nearest hit.
TEST_F(Hemispheres, HitsLieWithinBounds) {
  addMany();
  const scene::Snapshot s = snapshot();
  const ImpostorReach reach = reachOf(s.instances[0], s.camera);
  int hits = 0, besideBalls = 0;
  for (int i = 0; i < 4000; ++i) {
    for (uint32_t k = 0; k < centers.size(); ++k) {
      const double t = expected(k, wayOf(i));
      if (!std::isfinite(t)) continue;
      const glm::dvec3 hit = t * wayOf(i);
      const Box box = boundsOfImpostor(*s.instances[0].mesh, reach, k);
      ASSERT_TRUE(glm::all(glm::greaterThanEqual(hit, glm::dvec3(box.lower))) &&
                  glm::all(glm::lessThanEqual(hit, glm::dvec3(box.upper))));
      const glm::dvec3 from = glm::abs(hit - glm::dvec3(centers[k]));
      ++hits, besideBalls += std::max(from.x, from.y) > radii[k];
    }
  }
  EXPECT_GT(hits, 1000);
  EXPECT_GT(besideBalls, 50);
}

TEST_F(Hemispheres, BoundsDoNotDependOnTheRotationOfTheObject) {
  addMany();
  scene::Snapshot s = snapshot();
  const ImpostorReach reach = reachOf(s.instances[0], s.camera);
  const glm::dmat4 turned = glm::rotate(glm::dmat4(1), 0.7, {1, 2, 3});
  s.instances[0].eyeFromObject = turned, s.instances[0].lightingFromObject = glm::mat4(turned);
  EXPECT_EQ(reachOf(s.instances[0], s.camera), reach);
  s.camera.clipFromEye = glm::ortho(-3.0, 3.0, -3.0, 3.0, 0.5, 50.0);
  EXPECT_LT(reachOf(s.instances[0], s.camera).perRadius.x, 1.02f) << "in parallel, those of balls";
}

TEST_F(Hemispheres, ThatReachThroughTheNearPlaneDoNotExist) {
  centers = {{0, 0, -2}}, radii = {1.4f};
  for (const bool exists : {true, false}) {
    radii = {exists ? 1.4f : 1.6f};
    world.update(snapshot(), arena);
    EXPECT_EQ(shoot({0.1f, 0, -1}, 0).first, exists ? 0u : kNoHit);
    const scene::Snapshot s = snapshot();
    const PlacedImpostors placed(s.instances[0], s.camera);
    const ObjectRay across{{-10, 0, -2}, {1, 0, 0}, 0, 100};
    EXPECT_EQ(meetSolid(placed, 0, across).has_value(), exists);
    EXPECT_EQ(hullOf(placed, 0).has_value(), exists);
  }
}

TEST_F(Hemispheres, OtherRaysMeetWholeSpheres) {
  centers = {{0, 0, -4}}, radii = {1};
  const scene::Snapshot s = snapshot();
  const PlacedImpostors placed(s.instances[0], s.camera);
  const std::optional<SolidHit> behind = meetSolid(placed, 0, {{0, 0, -10}, {0, 0, 1}, 0, 100});
  ASSERT_TRUE(behind);
  EXPECT_NEAR(behind->t, 5, 1e-5);
  EXPECT_LT(behind->normal.z, 0);
}

}  // namespace
}  // namespace gluray::accel
