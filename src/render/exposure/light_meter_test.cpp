// Automatic exposure: lit surfaces stay as bright as in the program's own image.
#include "render/exposure/light_meter.h"

#include "base/log.h"
#include "render/testing/lit_wall.h"
#include "render/testing/test_ball.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gluray::render {
namespace {

using test::Shader;
using test::Traced;

/// A ball under a weak rig, with occlusion by a wall behind it.
scene::Snapshot dimBall(float strength) {
  scene::Snapshot s = test::litView({test::ballMesh(40)}, Shader::phong, {0, 0, 1, 0});
  s.shadings[0].fragment.normals = scene::FragmentShading::Normals::vertices;
  s.settings.shadows.enabled = false;
  s.settings.lights.rig = LightRig::headlightAndKey;
  s.settings.lights.strength = strength;
  s.settings.autoExposure = true;
  return s;
}

struct Exposed {
  std::optional<float> factor;
  Traced traced;
};

Exposed exposed(const scene::Snapshot& s) {
  Arena arena(s.settings.threads);
  accel::World world;
  world.update(s, arena);
  Exposed e{meteredExposure(s, world, arena), {}};
  TraceOptions options;
  options.litExposure = e.factor.value_or(1);
  traceImage(s, world, arena, e.traced.image, options);
  return e;
}

double meanLuminance(const Traced& traced) {
  double sum = 0;
  int count = 0;
  for (int y = 0; y < traced.image.height; ++y)
    for (int x = 0; x < traced.image.width; ++x)
      if (traced.hit(x, y))
        sum += glm::dot(glm::vec3(traced.color(x, y)), {0.2126f, 0.7152f, 0.0722f}), ++count;
  EXPECT_GT(count, 0);
  return sum / count;
}

TEST(LightMeter, SaysNothingOfPixelFilters) {
  scene::Snapshot s = dimBall(1);
  s.settings.spp = 4, s.settings.pixelFilter = PixelFilter::gauss;
  const size_t before = log::recent().size();
  exposed(s);
  EXPECT_EQ(log::recent().size(), before) << "its own images have one sample a pixel";
}

TEST(LightMeter, KeepsTheBrightnessOfTheProgramsImage) {
  scene::Snapshot own = dimBall(1);
  own.settings.lights.rig = LightRig::program;
  const double wanted = meanLuminance(test::trace(own));
  for (const float strength : {0.5f, 0.7f, 1.0f}) {
    const scene::Snapshot s = dimBall(strength);
    const Exposed e = exposed(s);
    ASSERT_TRUE(e.factor);
    EXPECT_NEAR(meanLuminance(e.traced), wanted, 0.03 * wanted) << strength;
    if (strength < 0.6f) { EXPECT_LT(meanLuminance(test::trace(s)), 0.7 * wanted) << "it was dark without"; }
  }
}

TEST(LightMeter, IsAskedForBySettingsThatChangeLight) {
  scene::Snapshot s = dimBall(1);
  EXPECT_TRUE(wantsMeter(s));
  s.settings.look = Look::honest;
  EXPECT_FALSE(wantsMeter(s));
  s = dimBall(1), s.settings.lights.rig = LightRig::program;
  EXPECT_FALSE(wantsMeter(s));
  s.settings.ao.enabled = true;
  EXPECT_TRUE(wantsMeter(s));
  s.settings.autoExposure = false;
  EXPECT_FALSE(wantsMeter(s));
}

TEST(LightMeter, LeavesUnlitSurfacesAsTheyAre) {
  scene::Snapshot s = dimBall(0.2f);
  s.shadings[0].fragment.model = scene::FragmentShading::Model::unlit;
  EXPECT_FALSE(exposed(s).factor) << "nothing lit is visible";
  Arena arena(s.settings.threads);
  accel::World world;
  world.update(s, arena);
  Traced bright, plain = test::trace(s);
  TraceOptions options;
  options.litExposure = 4;
  traceImage(s, world, arena, bright.image, options);
  EXPECT_EQ(bright.image.color, plain.image.color);
}

TEST(LightMeter, StaysWithinItsStops) {
  const Exposed e = exposed(dimBall(1e-4f));
  ASSERT_TRUE(e.factor);
  EXPECT_LE(*e.factor, std::exp2(kMaxStops) * 1.01f);
}

}  // namespace
}  // namespace gluray::render
