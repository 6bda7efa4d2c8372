// What backgrounds leave in images.
#include "render/frame_data/backdrop_look.h"
#include "render/lights/make_environment.h"
#include "render/testing/test_ground.h"
#include "scene/backdrop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace gluray::render {
namespace {

using test::isClearCase;
using test::isShadowed;
using test::kLitSize;
using test::onGround;
using test::plate;
using test::Traced;
using test::traceStaged;

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
  const Traced image = traceStaged(s);
  s.backdrop = nullptr;
  const Traced before = traceStaged(s);
  for (int y = 0; y < kLitSize; ++y) {
    for (int x = 0; x < kLitSize; ++x) {
      if (before.hit(x, y)) {
        ASSERT_EQ(image.color(x, y), before.color(x, y));
        ASSERT_EQ(image.depth(x, y), before.depth(x, y));
        continue;
      }
      ASSERT_EQ(image.image.centerDepth[image.at(x, y, 0)], Image::kMiss);
      const bool covers = x < kLitSize / 2;
      ASSERT_EQ(image.hit(x, y), covers);
      ASSERT_EQ(image.color(x, y), covers ? glm::vec4(255, 128, 0, 255) : glm::vec4(0));
      if (covers) { ASSERT_EQ(image.depth(x, y), BackdropLook::kDepth); }
    }
  }
}

TEST(Background, GradientRunsFromTheLowerToTheUpperSide) {
  const Traced image = traceStaged(painted(BackgroundKind::gradient));
  for (int y = 0; y < kLitSize; ++y) {
    const float up = (static_cast<float>(y) + 0.5f) / kLitSize;
    EXPECT_NEAR(image.color(0, y).r, 255 * up, 0.51f);
    EXPECT_NEAR(image.color(0, y).b, 255 * (1 - up), 0.51f);
  }
}

TEST(Background, EnvironmentIsThatOfEachPixelsRay) {
  scene::Snapshot s = painted(BackgroundKind::environment);
  s.settings.environment.kind = EnvironmentKind::gradient;
  const auto sky = makeEnvironment(s.settings, s.eyeFromWorld);
  const Traced image = traceStaged(s);
  const double slope = std::tan(glm::radians(20.0));
  for (int y = 0; y < kLitSize; y += 3) {
    const double up = ((y + 0.5) / (kLitSize / 2) - 1) * slope, right = (0.5 / (kLitSize / 2) - 1) * slope;
    const glm::vec3 expected = sky->radiance(glm::vec3(glm::normalize(glm::dvec3(right, up, -1))));
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(image.color(0, y)[c], 255 * std::min(expected[c], 1.0f), 0.6f) << y;
  }
}

TEST(Background, LiesUnderACatcher) {
  scene::Snapshot s = painted(BackgroundKind::color);
  s.settings.ground.kind = GroundKind::catcher;
  s.ground = scene::GroundUse::drawn;
  s.settings.shadows.strength = 0.5f;
  const Traced image = traceStaged(s);
  for (int y = 0; y < kLitSize / 2; ++y)
    for (int x = 0; x < kLitSize; ++x)
      if (const glm::dvec3 p = onGround(x, y); isClearCase(p)) {
        const float left = isShadowed(p) ? 0.5f : 1;
        ASSERT_NEAR(image.color(x, y).r, 255 * left, 1);
        ASSERT_NEAR(image.color(x, y).a, 255, 0.51);
      }
}

}  // namespace
}  // namespace gluray::render
