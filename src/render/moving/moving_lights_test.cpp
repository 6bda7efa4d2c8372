// Frames of animations whose lights turn with the camera.
#include "base/sanitized.h"
#include "render/testing/test_animation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gluray::render {
namespace {

using test::Animation;
using test::Mode;

/// The boards, lit from aside by a light that is fixed to the camera and casts soft shadows. With occlusion,
/// most light is ambient.
scene::Snapshot litBoards(bool occlusion) {
  scene::Snapshot s = test::boards();
  s.settings.ao.enabled = occlusion;
  s.settings.shadows.enabled = true, s.settings.shadows.size = 4;
  scene::Light light;
  light.position = {1.5f, 0.5f, 2, 0};
  light.diffuse = glm::vec4(occlusion ? 0.2f : 0.7f);
  light.ambient = glm::vec4(occlusion ? 0.8f : 0.3f);
  s.shadings[0].lighting = true, s.shadings[0].lights = {light};
  scene::Material white;
  white.ambient = white.diffuse = glm::vec4(1);
  for (scene::Instance& i : s.instances) i.materials = {{white, white}};
  return s;
}

double errorOf(const Image& image, const Image& truth) {
  double sum = 0, count = 0;
  for (size_t i = 0; i < image.color.size(); ++i) {
    if (truth.depth[i] == Image::kMiss) continue;
    const double d = double(image.color[i] & 255) - double(truth.color[i] & 255);
    sum += d * d, ++count;
  }
  EXPECT_GT(count, 1000);
  return sum / count;
}

/// Mean square errors of the last frame of an orbit, with the history of those before and without.
struct Errors {
  double known = 0, fresh = 0;
};
Errors errorsAfter(scene::Snapshot s, double step, MovingRays rays) {
  Animation animation;
  animation.rays = rays;
  test::Traced last;
  for (int i = 0; i < 12; ++i) test::turn(s, step * i), last = animation.frame(s);
  scene::Snapshot full = s;
  full.settings.shadows.samples = 256;
  const test::Traced truth = animation.converged(full);
  Animation none;
  return {errorOf(last.image, truth.image), errorOf(none.frame(s).image, truth.image)};
}

TEST(MovingLights, FramesKeepTheHistoryOfOcclusion) {
  GLURAY_RELEASE_ONLY();
  const Errors errors = errorsAfter(litBoards(true), 1, {1, false});
  EXPECT_LT(errors.known, 0.75 * errors.fresh);
}

TEST(MovingLights, ShadowsDoNotStayBehind) {
  GLURAY_RELEASE_ONLY();
  for (const double step : {1.0, 10.0}) {
    const Errors all = errorsAfter(litBoards(false), step, {1, false});
    EXPECT_LT(all.known, 1.15 * all.fresh) << step;
  }
  // Far turns: a quarter of the rays would show old shadows.
  const Errors quarter = errorsAfter(litBoards(false), 10, {1, true});
  EXPECT_LT(quarter.known, 1.15 * quarter.fresh);
}

}  // namespace
}  // namespace gluray::render
