// Light that the surroundings of occluded points reflect (setting ao.interreflection).
#include "render/effects/ambient_occlusion.h"
#include "render/testing/test_ball.h"
#include "render/testing/test_trace.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace gluray::render {
namespace {

TEST(Interreflection, MakesOccludedPointsOfBrightSurfacesLessDark) {
  // Jimenez and others 2016, table of section 5: the fit is exact without occlusion and with all of it.
  for (const float reflectance : {0.0f, 0.3f, 0.9f}) {
    EXPECT_NEAR(AmbientOcclusion::withReflections(1, reflectance), 1, 2e-3f);
    EXPECT_EQ(AmbientOcclusion::withReflections(0, reflectance), 0);
  }
  EXPECT_EQ(AmbientOcclusion::withReflections(0.5f, 0), 0.5f);
  EXPECT_NEAR(AmbientOcclusion::withReflections(0.5f, 0.8f), 0.812f, 2e-3f);
  // Half of the sky of the wall z = 0 is hidden by the wall x = 3, beyond the view.
  constexpr int kSize = 32;
  scene::Snapshot s = test::makeSnapshot({test::parallelogram({0, 0, 0}, {500, 0, 0}, {0, 500, 0}),
                                          test::parallelogram({3, 0, 5e4f}, {0, 5e5f, 0}, {0, 0, 5e4f})},
                                         kSize);
  s.camera.clipFromEye = glm::perspective(glm::radians(40.0), 1.0, 0.1, 1000.0);
  s.eyeFromWorld = glm::translate(glm::dmat4(1), {0, 0, -5});
  for (scene::Instance& instance : s.instances) instance.eyeFromObject = s.eyeFromWorld;
  s.settings.ao.enabled = true, s.settings.ao.samples = 256, s.settings.ao.radius = 100;
  s.settings.ao.interreflection = true;
  for (scene::Instance& instance : s.instances) instance.color = {0.8f, 0.8f, 0.1f, 1};
  const glm::vec4 seen = test::trace(s).color(kSize / 2, kSize / 2) / 255.0f;
  EXPECT_NEAR(seen.r, 0.8f * 0.812f, 0.03f);
  EXPECT_NEAR(seen.b, 0.1f * 0.5f, 0.01f) << "black surfaces reflect nothing";
}

}  // namespace
}  // namespace gluray::render
