// The ground: where it lies, and what it shows.
#include "render/ground/ground_place.h"
#include "render/ground/staged_scene.h"
#include "render/testing/test_ground.h"
#include "scene/secondary_scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gluray::render {
namespace {

using test::isClearCase;
using test::isOnGround;
using test::isShadowed;
using test::kLitSize;
using test::onGround;
using test::plate;
using test::Traced;
using test::traceStaged;

TEST(Ground, LiesWhereItShouldWithItsDepthAndShadow) {
  const scene::Snapshot s = plate(GroundKind::plane);
  const Traced image = traceStaged(s);
  int lit = 0, shadowed = 0;
  for (int y = 0; y < kLitSize / 2; ++y) {
    for (int x = 0; x < kLitSize; ++x) {
      const glm::dvec3 p = onGround(x, y);
      if (!isClearCase(p)) continue;
      ASSERT_EQ(image.hit(x, y), isOnGround(p)) << x << ' ' << y;
      if (!isOnGround(p)) continue;
      const glm::dvec4 clip = s.camera.clipFromEye * s.eyeFromWorld * glm::dvec4(p, 1);
      ASSERT_NEAR(image.depth(x, y), 0.5 * clip.z / clip.w + 0.5, 1e-6);
      ASSERT_EQ(image.color(x, y), glm::vec4(glm::vec3(isShadowed(p) ? 0 : 255), 255)) << x << ' ' << y;
      ++(isShadowed(p) ? shadowed : lit);
    }
  }
  EXPECT_GT(lit, 300);
  EXPECT_GT(shadowed, 20);
}

TEST(Ground, IsSeenBeyondTheProgramsNearAndFarPlanes) {
  const Traced wide = traceStaged(plate(GroundKind::plane)),
               tight = traceStaged(plate(GroundKind::plane, 1, 4.4, 5.6));
  for (int y = 0; y < kLitSize / 2; ++y) {
    for (int x = 0; x < kLitSize; ++x) {
      ASSERT_EQ(wide.hit(x, y), tight.hit(x, y)) << x << ' ' << y;
      ASSERT_EQ(wide.color(x, y), tight.color(x, y)) << x << ' ' << y;
      if (tight.hit(x, y)) { ASSERT_TRUE(tight.depth(x, y) > 0 && tight.depth(x, y) < 1); }
    }
  }
}

TEST(Ground, IsTheSameInScenesOfAnySize) {
  const Traced one = traceStaged(plate(GroundKind::plane));
  for (const double size : {1e-15, 1e-6, 1e6, 1e14}) {
    const Traced other = traceStaged(plate(GroundKind::plane, size));
    int differ = 0;
    for (size_t i = 0; i < one.image.color.size(); ++i) differ += one.image.color[i] != other.image.color[i];
    EXPECT_LT(differ, 40) << size << ": pixels at the rims";
  }
}

TEST(Ground, MeshesStayEqualWhileTheSceneChangesLittle) {
  scene::Snapshot s = plate(GroundKind::plane);
  const StagedScene a(s);
  s.settings.ground.size = 9.5f;
  const StagedScene b(s);
  EXPECT_EQ(a.snapshot().instances.back().mesh->geometryId, b.snapshot().instances.back().mesh->geometryId);
}

TEST(Ground, StandsAcrossTheUpwardAxisOfTheViewsFirstObject) {
  scene::Snapshot s = plate(GroundKind::plane);
  for (int up = 0; up < 3; ++up) {
    s.settings.lights.up = static_cast<decltype(s.settings.lights.up)>(up);
    const auto place = placeGround(s);
    ASSERT_TRUE(place);
    glm::dvec3 axis(0);
    axis[up] = 1;
    EXPECT_EQ(glm::normalize(glm::dvec3(place->worldFromObject[2])), axis);
    const double lowest = up == 1 ? 0.4 : -0.5;
    EXPECT_NEAR(place->worldFromObject[3][up], lowest - std::sqrt(2.0), 1e-6);
  }
  // An object space that is stretched along the upward axis: lengths are what the viewer sees.
  s.settings.lights.up = static_cast<decltype(s.settings.lights.up)>(1);
  s.eyeFromWorld = glm::scale(s.eyeFromWorld, {1, 10, 1});
  for (auto& instance : s.instances) instance.eyeFromObject = s.eyeFromWorld;
  EXPECT_NEAR(placeGround(s)->worldFromObject[3].y, 0.4 - std::sqrt(2.0) / 10, 1e-6);
}

TEST(Ground, HidesTheSkyOfOtherBatchesWithoutBeingSeenInThem) {
  scene::Snapshot s = plate(GroundKind::plane);
  s.settings.shadows.enabled = false;
  s.settings.ao.enabled = true;
  s.settings.ao.radius = 1000;
  s.ground = scene::GroundUse::around;
  const StagedScene staged(s);
  EXPECT_EQ(staged.snapshot().instances.size(), 1u);
  ASSERT_TRUE(staged.snapshot().secondaryScene);
  EXPECT_TRUE(staged.snapshot().secondaryScene->instances.back().ground);
  const Traced with = traceStaged(s);
  s.ground = scene::GroundUse::none;
  const Traced without = traceStaged(s);
  EXPECT_FALSE(with.hit(kLitSize / 2, 2));
  glm::vec4 dark(0), bright(0);
  for (int y = kLitSize / 2; y < kLitSize; ++y)
    for (int x = 0; x < kLitSize; ++x)
      if (with.hit(x, y)) dark += with.color(x, y), bright += without.color(x, y);
  EXPECT_LE(dark.x, bright.x);
}

}  // namespace
}  // namespace gluray::render
