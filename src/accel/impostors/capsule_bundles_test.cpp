// Bundles of capsules against the single capsules: none is lost, and few more than needed are left over.
#include "accel/impostors/capsule_bundles.h"

#include "accel/impostors/solid.h"
#include "accel/testing/test_scene.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gluray::accel {
namespace {

constexpr uint32_t kBundled = 1200;

/// Evenly spread over [-1, 1]^3.
glm::vec3 spreadOut(uint32_t i, double first) {
  const auto at = [&](double step) {
    const double x = 0.5 + first * step * (i + 1);
    return static_cast<float>(2 * (x - std::floor(x)) - 1);
  };
  return {at(0.754877666), at(0.569840296), at(0.362109)};
}

/// Short lines within [-1, 1]^3 `size` times as large, five sizes before the viewer.
scene::Instance bundledLines(float size, const glm::dvec3& stretched, bool inPixels) {
  std::vector<glm::vec3> points;
  for (uint32_t i = 0; i < kBundled; ++i) {
    const glm::vec3 at = spreadOut(i, 1);
    points.push_back(size * at), points.push_back(size * (at + 0.15f * spreadOut(i, 7)));
  }
  auto mesh = std::make_shared<scene::Mesh>();
  mesh->shape = scene::Shape::capsules;
  mesh->vertexCount = 2 * kBundled, mesh->triangleCount = kBundled;
  mesh->lower = glm::vec3(-1.2f * size), mesh->upper = glm::vec3(1.2f * size);
  mesh->positions = test::makeAttribute(std::move(points), scene::Format::float3);
  scene::Instance instance;
  instance.mesh = mesh;
  instance.eyeFromObject = glm::scale(
      glm::rotate(glm::translate(glm::dmat4(1), {0.1 * size, 0.2 * size, -5.0 * size}), 0.7, {1, 2, 3}),
      stretched);
  instance.lightingFromObject = glm::mat4(instance.eyeFromObject);
  instance.impostors.size = {0.02f, 0.02f};
  if (!inPixels) instance.impostors.radius = 0.03f * size;
  return instance;
}

scene::Camera bundleCamera(double size) {
  scene::Camera camera;
  camera.viewport = {0, 0, 200, 200};
  camera.clipFromEye = glm::perspective(glm::radians(60.0), 1.0, 0.1 * size, 100 * size);
  return camera;
}

TEST(CapsuleBundles, HoldEachCapsuleOnce) {
  const Device device;
  scene::Instance instance = bundledLines(1, glm::dvec3(1), false);
  const ImpostorReach reach = reachOf(instance, bundleCamera(1));
  for (const bool fast : {false, true}) {
    const CapsuleBundles bundles(device, *instance.mesh, reach, fast);
    std::vector<uint32_t> held;
    for (uint32_t i = 0; i < bundles.count(); ++i) {
      const CapsuleBundle& b = bundles[i];
      ASSERT_GE(b.count, 1u);
      ASSERT_LE(b.count, 8u);
      const Box all = bundles.boxOf(i);
      for (uint32_t k = 0; k < b.count; ++k) {
        held.push_back(b.primitive[k]);
        const Box one = boundsOfImpostor(*instance.mesh, reach, b.primitive[k]);
        EXPECT_EQ(glm::min(all.lower, one.lower), all.lower);
        EXPECT_EQ(glm::max(all.upper, one.upper), all.upper);
      }
    }
    std::sort(held.begin(), held.end());
    ASSERT_EQ(held.size(), kBundled);
    for (uint32_t i = 0; i < kBundled; ++i) ASSERT_EQ(held[i], i);
    EXPECT_LT(bundles.count(), kBundled / 4);
  }
}

/// Capsules with these ends, of a small radius.
scene::Instance capsulesOf(std::vector<glm::vec3> ends) {
  scene::Instance instance = bundledLines(1, glm::dvec3(1), false);
  auto mesh = std::make_shared<scene::Mesh>(*instance.mesh);
  mesh->vertexCount = static_cast<uint32_t>(ends.size()), mesh->triangleCount = mesh->vertexCount / 2;
  mesh->positions = test::makeAttribute(std::move(ends), scene::Format::float3);
  instance.mesh = mesh;
  instance.impostors.radius = 1e-6f;
  return instance;
}

uint32_t bundledIn(const scene::Instance& instance) {
  const Device device;
  const CapsuleBundles bundles(device, *instance.mesh, reachOf(instance, bundleCamera(1)), false);
  uint32_t all = 0;
  for (uint32_t i = 0; i < bundles.count(); ++i) all += bundles[i].count;
  return all;
}

// Streamlines end in points that they never reach: trees of them are as deep as floats are fine.
TEST(CapsuleBundles, TakeLinesThatConverge) {
  std::vector<glm::vec3> ends;
  for (int line = 0; line < 40; ++line) {
    glm::vec3 at = spreadOut(static_cast<uint32_t>(line), 3);
    for (int step = 0; step < 120; ++step, at *= 0.5f) ends.push_back(at), ends.push_back(0.5f * at);
  }
  EXPECT_EQ(bundledIn(capsulesOf(ends)), 40u * 120);
}

TEST(CapsuleBundles, TakeManyAtOnePlace) {
  EXPECT_EQ(bundledIn(capsulesOf(std::vector<glm::vec3>(20000, {0.3f, 0.2f, 0.1f}))), 10000u);
}

TEST(CapsuleBundles, LeaveOutWhatIsInfinitelyFar) {
  std::vector<glm::vec3> ends(2000, {0.3f, 0.2f, 0.1f});
  ends[17].x = INFINITY, ends[300].y = -INFINITY, ends[500].z = 3e38f;
  EXPECT_LE(bundledIn(capsulesOf(ends)), 1000u);
}

TEST(CapsuleBundles, LeaveOutWhatDoesNotExist) {
  const Device device;
  scene::Instance instance = bundledLines(1, glm::dvec3(1), false);
  auto mesh = std::make_shared<scene::Mesh>(*instance.mesh);
  std::vector<glm::vec3> points(2 * kBundled);
  for (uint32_t i = 0; i < points.size(); ++i) points[i] = mesh->position(i);
  points[7] = glm::vec3(NAN), points[100] = glm::vec3(INFINITY);
  mesh->positions = test::makeAttribute(std::move(points), scene::Format::float3);
  const CapsuleBundles bundles(device, *mesh, reachOf(instance, bundleCamera(1)), false);
  uint32_t held = 0;
  for (uint32_t i = 0; i < bundles.count(); ++i) held += bundles[i].count;
  EXPECT_EQ(held, kBundled - 2);
}

struct NearCounts {
  int hits = 0, kept = 0, all = 0;
};

/// Packets of 16 rays that begin in and around the cube. Fails where a capsule that a ray meets is left out.
NearCounts compareNear(const scene::Instance& instance, float size, float away) {
  const Device device;
  const PlacedImpostors placed(instance, bundleCamera(size));
  const CapsuleBundles bundles(device, *instance.mesh, reachOf(instance, bundleCamera(size)), false);
  NearCounts counts;
  for (uint32_t n = 0; n < 400; ++n) {
    const CapsuleBundle& b = bundles[n % bundles.count()];
    alignas(64) float rows[9][16];
    for (uint32_t i = 0; i < 16; ++i) {
      const uint32_t at = b.primitive[i % b.count];
      const glm::vec3 to = spreadOut(at, 1) + 0.1f * spreadOut(16 * n + i, 3);
      const glm::vec3 from = to + away * spreadOut(16 * n + i, 5);
      for (int c = 0; c < 3; ++c)
        rows[c][i] = size * from[c], rows[4 + c][i] = (i % 3 ? 1.0f : 1e-3f) * size * (to[c] - from[c]);
      rows[3][i] = i % 5 ? 0 : 0.3f, rows[7][i] = 0, rows[8][i] = i % 7 ? test::kInfinity : 1.1f;
    }
    uint32_t near[CapsuleBundle::kMost];
    const uint32_t lanes = n % 2 ? 0xFFFFu : 1u << n % 16;
    nearCapsules(b, placed, rows[0], 16, lanes, near);
    for (uint32_t k = 0; k < b.count; ++k) {
      EXPECT_EQ(near[k] & ~lanes, 0u);
      for (uint32_t i = 0; i < 16; ++i) {
        if (!(lanes >> i & 1)) continue;
        const ObjectRay ray{{rows[0][i], rows[1][i], rows[2][i]},
                            {rows[4][i], rows[5][i], rows[6][i]},
                            rows[3][i],
                            rows[8][i]};
        const bool hit = meetSolid(placed, b.primitive[k], ray).has_value(), kept = near[k] >> i & 1;
        EXPECT_TRUE(kept || !hit) << "bundle " << n << " capsule " << k << " ray " << i;
        ++counts.all, counts.hits += hit, counts.kept += kept;
      }
    }
  }
  return counts;
}

TEST(CapsuleBundles, KeepAllThatRaysMeetAndLittleMore) {
  for (const float size : {1.0f, 1e-4f, 1e5f})
    for (const bool inPixels : {false, true})
      for (const float away : {0.2f, 3.0f, 200.0f}) {
        const NearCounts counts = compareNear(bundledLines(size, glm::dvec3(1), inPixels), size, away);
        EXPECT_GT(counts.hits, 200);
        EXPECT_LT(counts.kept, 1.2 * counts.hits + 0.01 * counts.all)
            << size << " " << inPixels << " " << away;
      }
}

TEST(CapsuleBundles, KeepAllUnderAnyScale) {
  for (const glm::dvec3& stretched : {glm::dvec3(1, 1, 3), glm::dvec3(0.2, 1, 1), glm::dvec3(-1, 2, 0.5)})
    for (const bool inPixels : {false, true})
      EXPECT_GT(compareNear(bundledLines(1, stretched, inPixels), 1, 3).hits, 200);
}

}  // namespace
}  // namespace gluray::accel
