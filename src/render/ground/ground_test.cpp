// The ground: where it lies, what it shows, and what a catcher and backgrounds leave in pictures.
#include "base/testing/temporary_folder.h"
#include "render/frame_data/backdrop_look.h"
#include "render/ground/ground_place.h"
#include "render/ground/staged_scene.h"
#include "render/lights/make_environment.h"
#include "render/testing/lit_wall.h"
#include "scene/surroundings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace gluray::render {
namespace {

using test::kLitSize;
using test::Traced;

Traced traceStaged(const scene::Snapshot& s) {
  const StagedScene staged(s);
  Arena arena(2);
  accel::World world;
  world.update(staged.snapshot(), arena, staged.hidden());
  Traced traced;
  traceImage(staged.snapshot(), world, arena, traced.image);
  return traced;
}

constexpr double kPlateHeight = 0.4;  // of the plate above the eye
const double kBelow =
    std::sqrt(2.0) - kPlateHeight;        // of the ground below the eye: one diagonal of the plate
const double kHalf = 5 * std::sqrt(2.0);  // of the ground's width

/// A level plate of width 1 over a ground one diagonal below, lit from straight above. The viewer at (0, 0,
/// 5) looks along -z.
scene::Snapshot plate(GroundKind kind, double size = 1, double near = 0.1, double far = 1000) {
  const auto z = static_cast<float>(size);
  auto mesh =
      test::makeMesh(test::quadData(glm::vec3(-0.5f, 0.4f, -0.5f) * z, glm::vec3(0.5f, 0.4f, -0.5f) * z,
                                    glm::vec3(0.5f, 0.4f, 0.5f) * z, glm::vec3(-0.5f, 0.4f, 0.5f) * z));
  mesh->lower = glm::vec3(-0.5f, 0.4f, -0.5f) * z, mesh->upper = glm::vec3(0.5f, 0.4f, 0.5f) * z;
  scene::Snapshot s = test::litView({mesh}, test::Shader::fixedFunction, {0, 1, 0, 0});
  s.camera.clipFromEye = glm::perspective(glm::radians(40.0), 1.0, near * size, far * size);
  s.eyeFromWorld = glm::translate(glm::dmat4(1), {0, 0, -5 * size});
  for (scene::Instance& instance : s.instances) instance.eyeFromObject = s.eyeFromWorld;
  s.settings.ground.kind = kind;
  s.settings.ground.offset = 1;
  s.settings.ground.color = glm::vec3(1);
  s.ground = scene::GroundUse::drawn;
  return s;
}

/// Where the ray through a pixel meets the ground, by plain arithmetic.
glm::dvec3 onGround(int x, int y) {
  const double slope = std::tan(glm::radians(20.0));
  const glm::dvec3 way(((x + 0.5) / (kLitSize / 2) - 1) * slope, ((y + 0.5) / (kLitSize / 2) - 1) * slope,
                       -1);
  const double t = -kBelow / way.y;
  return t > 0 ? glm::dvec3(0, 0, 5) + t * way : glm::dvec3(1e9);
}
bool isOnGround(const glm::dvec3& p) { return std::abs(p.x) <= kHalf && std::abs(p.z) <= kHalf; }
/// Not at the rim of the shadow nor of the ground.
bool isClearCase(const glm::dvec3& p) {
  const double m = std::max(std::abs(p.x), std::abs(p.z));
  return std::abs(m - 0.5) > 0.02 && std::abs(m - kHalf) > 0.2;
}
bool isShadowed(const glm::dvec3& p) { return std::abs(p.x) < 0.5 && std::abs(p.z) < 0.5; }

TEST(Ground, LiesWhereItShouldWithItsDepthAndShadow) {
  const scene::Snapshot s = plate(GroundKind::plane);
  const Traced picture = traceStaged(s);
  int lit = 0, shadowed = 0;
  for (int y = 0; y < kLitSize / 2; ++y) {
    for (int x = 0; x < kLitSize; ++x) {
      const glm::dvec3 p = onGround(x, y);
      if (!isClearCase(p)) continue;
      ASSERT_EQ(picture.hit(x, y), isOnGround(p)) << x << ' ' << y;
      if (!isOnGround(p)) continue;
      const glm::dvec4 clip = s.camera.clipFromEye * s.eyeFromWorld * glm::dvec4(p, 1);
      ASSERT_NEAR(picture.depth(x, y), 0.5 * clip.z / clip.w + 0.5, 1e-6);
      ASSERT_EQ(picture.color(x, y), glm::vec4(glm::vec3(isShadowed(p) ? 0 : 255), 255)) << x << ' ' << y;
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
  ASSERT_TRUE(staged.snapshot().surroundings);
  EXPECT_TRUE(staged.snapshot().surroundings->instances.back().ground);
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

TEST(Catcher, AlphaIsTheShareOfLightThatDoesNotArrive) {
  for (const float strength : {1.0f, 0.6f}) {
    scene::Snapshot s = plate(GroundKind::catcher);
    s.settings.shadows.strength = strength;
    const Traced picture = traceStaged(s);
    ASSERT_TRUE(picture.image.isAverages());
    int shadowed = 0;
    for (int y = 0; y < kLitSize / 2; ++y) {
      for (int x = 0; x < kLitSize; ++x) {
        const glm::dvec3 p = onGround(x, y);
        if (!isClearCase(p) || !isOnGround(p)) continue;
        const float hidden = isShadowed(p) ? strength : 0;
        ASSERT_NEAR(picture.color(x, y).a, 255 * hidden, 0.51) << x << ' ' << y;
        ASSERT_EQ(glm::vec3(picture.color(x, y)), glm::vec3(0));
        ASSERT_EQ(picture.image.centerDepth[picture.at(x, y, 0)], Image::kMiss) << "it hides nothing";
        ASSERT_LT(picture.depth(x, y), 1) << "but lies where it is";
        shadowed += isShadowed(p);
      }
    }
    EXPECT_GT(shadowed, 20);
  }
}

TEST(Catcher, PathsGiveTheSameOfDirectLight) {
  scene::Snapshot s = plate(GroundKind::catcher);
  s.settings.integrator = LightIntegrator::path;
  s.settings.path.depth = 1;
  s.settings.environment.strength = 0;
  const Traced picture = traceStaged(s);
  for (int y = 0; y < kLitSize / 2; ++y)
    for (int x = 0; x < kLitSize; ++x)
      if (const glm::dvec3 p = onGround(x, y); isClearCase(p) && isOnGround(p)) {
        ASSERT_NEAR(picture.color(x, y).a, isShadowed(p) ? 255 : 0, 0.51) << x << ' ' << y;
      }
}

TEST(Catcher, SceneItselfStaysAsItIs) {
  scene::Snapshot s = plate(GroundKind::catcher);
  const Traced with = traceStaged(s);
  s.settings.ground.kind = GroundKind::off;
  s.ground = scene::GroundUse::none;
  const Traced without = traceStaged(s);
  for (int y = kLitSize / 2; y < kLitSize; ++y)
    for (int x = 0; x < kLitSize; ++x) {
      ASSERT_EQ(with.hit(x, y), without.hit(x, y));
      if (with.hit(x, y)) { ASSERT_EQ(with.color(x, y), without.color(x, y)); }
    }
}

scene::Snapshot painted(BackgroundKind kind) {
  scene::Snapshot s = plate(GroundKind::off);
  s.ground = scene::GroundUse::none;
  s.settings.background.kind = kind;
  s.settings.background.color = {1, 0.5f, 0};
  s.settings.background.bottom = {0, 0.5f, 1};
  s.backdrop = std::make_shared<scene::Backdrop>();
  return s;
}

TEST(Background, ShowsWhereNothingIsHitAndNowhereElse) {
  scene::Snapshot s = painted(BackgroundKind::color);
  auto half = std::make_shared<scene::Backdrop>();
  for (int i = 0; i < kLitSize * kLitSize; ++i) half->isClear.push_back(i % kLitSize < kLitSize / 2);
  s.backdrop = half;
  const Traced picture = traceStaged(s);
  s.backdrop = nullptr;
  const Traced before = traceStaged(s);
  for (int y = 0; y < kLitSize; ++y) {
    for (int x = 0; x < kLitSize; ++x) {
      if (before.hit(x, y)) {
        ASSERT_EQ(picture.color(x, y), before.color(x, y));
        ASSERT_EQ(picture.depth(x, y), before.depth(x, y));
        continue;
      }
      ASSERT_EQ(picture.image.centerDepth[picture.at(x, y, 0)], Image::kMiss);
      const bool covers = x < kLitSize / 2;
      ASSERT_EQ(picture.hit(x, y), covers);
      ASSERT_EQ(picture.color(x, y), covers ? glm::vec4(255, 128, 0, 255) : glm::vec4(0));
      if (covers) { ASSERT_EQ(picture.depth(x, y), BackdropLook::kDepth); }
    }
  }
}

TEST(Background, GradientRunsFromTheLowerToTheUpperSide) {
  const Traced picture = traceStaged(painted(BackgroundKind::gradient));
  for (int y = 0; y < kLitSize; ++y) {
    const float up = (static_cast<float>(y) + 0.5f) / kLitSize;
    EXPECT_NEAR(picture.color(0, y).r, 255 * up, 0.51f);
    EXPECT_NEAR(picture.color(0, y).b, 255 * (1 - up), 0.51f);
  }
}

TEST(Background, EnvironmentIsThatOfEachPixelsRay) {
  scene::Snapshot s = painted(BackgroundKind::environment);
  s.settings.environment.kind = EnvironmentKind::gradient;
  const auto sky = makeEnvironment(s.settings, s.eyeFromWorld);
  const Traced picture = traceStaged(s);
  const double slope = std::tan(glm::radians(20.0));
  for (int y = 0; y < kLitSize; y += 3) {
    const double up = ((y + 0.5) / (kLitSize / 2) - 1) * slope, right = (0.5 / (kLitSize / 2) - 1) * slope;
    const glm::vec3 expected = sky->radiance(glm::vec3(glm::normalize(glm::dvec3(right, up, -1))));
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(picture.color(0, y)[c], 255 * std::min(expected[c], 1.0f), 0.6f) << y;
  }
}

TEST(Background, LiesUnderACatcher) {
  scene::Snapshot s = painted(BackgroundKind::color);
  s.settings.ground.kind = GroundKind::catcher;
  s.ground = scene::GroundUse::drawn;
  s.settings.shadows.strength = 0.5f;
  const Traced picture = traceStaged(s);
  for (int y = 0; y < kLitSize / 2; ++y)
    for (int x = 0; x < kLitSize; ++x)
      if (const glm::dvec3 p = onGround(x, y); isClearCase(p)) {
        const float left = isShadowed(p) ? 0.5f : 1;
        ASSERT_NEAR(picture.color(x, y).r, 255 * left, 1);
        ASSERT_NEAR(picture.color(x, y).a, 255, 0.51);
      }
}

/// The wall and a screen that shades it, under a rule.
Traced screened(const std::string& rule, bool ao = false) {
  const test::TemporaryFolder folder;
  scene::Snapshot s =
      test::litView({test::wall(), test::parallelogram({0, 0, 2}, {0.3f, 0, 0}, {0, 0.3f, 0})},
                    test::Shader::fixedFunction, {0.5f, 0, 1, 0});
  s.instances[1].order = 1;
  s.settings.shadows.enabled = !ao;
  s.settings.ao.enabled = ao;
  s.settings.ao.radius = 10;
  s.settings.ao.samples = 64;
  s.settings.material.file = folder.write("rules.toml", rule);
  return traceStaged(s);
}

TEST(HiddenFrom, RulesHideObjectsFromTheCameraAlone) {
  const Traced all = screened("[[rule]]\nobjects = [1]\n"),
               hidden = screened("[[rule]]\nobjects = [1]\nhidden-from = [\"camera\"]\n");
  // The screen is seen in the middle, 3 away; its shadow falls on x = -1.
  EXPECT_LT(all.depth(32, 32), hidden.depth(32, 32));
  EXPECT_EQ(hidden.depth(32, 32), hidden.depth(60, 32)) << "the wall behind has its own depth";
  int shadow = 0;
  for (int x = 0; x < kLitSize; ++x) shadow += hidden.color(x, 32).r == 0;
  EXPECT_GE(shadow, 8) << "it still casts its shadow";
}

TEST(HiddenFrom, RulesTakeShadowsAndOcclusionAway) {
  const auto shadowOf = [](const Traced& t) {
    int count = 0;
    for (int x = 0; x < kLitSize; ++x) count += t.color(x, 32).r < 100;
    return count;
  };
  EXPECT_GE(shadowOf(screened("")), 5);
  EXPECT_GE(shadowOf(screened("[[rule]]\nobjects = [1]\nhidden-from = [\"occlusion\", \"reflection\"]\n")),
            5);
  EXPECT_EQ(shadowOf(screened("[[rule]]\nobjects = [1]\nhidden-from = [\"shadow\"]\n")), 0);
  const auto beside = [](const Traced& t) { return t.color(46, 32).r; };
  const float open = beside(screened("[[rule]]\nobjects = [1]\nhidden-from = [\"occlusion\"]\n", true));
  EXPECT_LT(beside(screened("", true)), open);
  EXPECT_LT(beside(screened("[[rule]]\nobjects = [1]\nhidden-from = [\"shadow\"]\n", true)), open);
}

TEST(StagedScene, IsTheSnapshotItselfWhereSettingsAskForNothing) {
  scene::Snapshot s = plate(GroundKind::off);
  s.ground = scene::GroundUse::none;
  const StagedScene staged(s);
  EXPECT_EQ(&staged.snapshot(), &s);
  EXPECT_TRUE(staged.hidden().empty());
}

}  // namespace
}  // namespace gluray::render
