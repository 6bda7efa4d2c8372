// What a catcher leaves in images.
#include "render/testing/test_ground.h"

#include <gtest/gtest.h>

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

TEST(Catcher, AlphaIsTheShareOfLightThatDoesNotArrive) {
  for (const float strength : {1.0f, 0.6f}) {
    scene::Snapshot s = plate(GroundKind::catcher);
    s.settings.shadows.strength = strength;
    const Traced image = traceStaged(s);
    ASSERT_TRUE(image.image.isAverages());
    int shadowed = 0;
    for (int y = 0; y < kLitSize / 2; ++y) {
      for (int x = 0; x < kLitSize; ++x) {
        const glm::dvec3 p = onGround(x, y);
        if (!isClearCase(p) || !isOnGround(p)) continue;
        const float hidden = isShadowed(p) ? strength : 0;
        ASSERT_NEAR(image.color(x, y).a, 255 * hidden, 0.51) << x << ' ' << y;
        ASSERT_EQ(glm::vec3(image.color(x, y)), glm::vec3(0));
        ASSERT_EQ(image.image.centerDepth[image.at(x, y, 0)], Image::kMiss) << "it hides nothing";
        ASSERT_LT(image.depth(x, y), 1) << "but lies where it is";
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
  const Traced image = traceStaged(s);
  for (int y = 0; y < kLitSize / 2; ++y)
    for (int x = 0; x < kLitSize; ++x)
      if (const glm::dvec3 p = onGround(x, y); isClearCase(p) && isOnGround(p)) {
        ASSERT_NEAR(image.color(x, y).a, isShadowed(p) ? 255 : 0, 0.51) << x << ' ' << y;
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

}  // namespace
}  // namespace gluray::render
