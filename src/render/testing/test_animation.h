// Boards under a camera that turns, and frames of them one after another, for tests.
#pragma once
#include "render/testing/test_trace.h"

#include <glm/gtc/matrix_transform.hpp>

namespace gluray::test {

constexpr int kMovingSize = 96;
using Mode = scene::LightSampling::Mode;

/// A floor and three boards on edge, `size` times as large as they were made, white and unlit.
inline scene::Snapshot boards(float size = 1) {
  const auto at = [&](float x, float y, float z) { return glm::vec3(x, y, z) * size; };
  scene::Snapshot s = makeSnapshot({parallelogram(at(0, 0, 0), at(3, 0, 0), at(0, 3, 0)),
                                    parallelogram(at(-0.9f, 0, 0.4f), at(0, 0.8f, 0), at(0, 0, 0.4f)),
                                    parallelogram(at(0.1f, 0.3f, 0.3f), at(0.3f, 0.4f, 0), at(0, 0, 0.3f)),
                                    parallelogram(at(0.8f, -0.4f, 0.5f), at(0.2f, -0.1f, 0), at(0, 0, 0.5f))},
                                   kMovingSize);
  s.view = 7;
  s.settings.ao.enabled = true;
  s.settings.ao.radius = 0.2f;
  return s;
}

/// Looks at the boards from above, turned by `degrees`.
inline void turn(scene::Snapshot& s, double degrees, double size = 1) {
  s.camera.clipFromEye = glm::perspective(glm::radians(35.0), 1.0, 0.5 * size, 20 * size);
  s.eyeFromWorld =
      glm::rotate(glm::translate(glm::dmat4(1), {0, 0, -5 * size}), glm::radians(-40.0), {1, 0, 0}) *
      glm::rotate(glm::dmat4(1), glm::radians(degrees), {0, 0, 1});
  for (scene::Instance& i : s.instances) i.eyeFromObject = s.eyeFromWorld * glm::dmat4(i.worldFromObject);
}

/// Traces frames one after another.
struct Animation {
  Arena arena{2};
  accel::World world;
  render::LightHistories histories;
  render::MovingRays rays;

  Traced frame(scene::Snapshot s, Mode mode = Mode::moving) {
    s.lightSampling.mode = mode;
    world.update(s, arena);
    Traced traced;
    render::traceImage(s, world, arena, traced.image, {&histories, rays});
    return traced;
  }
  /// The same with 256 samples.
  Traced converged(scene::Snapshot s) {
    s.settings.ao.samples = 256;
    return frame(s, Mode::full);
  }
};

}  // namespace gluray::test
