// The upward axis of scenes (setting lights.up). Any thread.
#pragma once
#include "scene/snapshot.h"

#include <glm/glm.hpp>

namespace gluray::scene {

/// 0: x, 1: y, 2: z. Where it is to be found and nobody has yet: y.
inline int upwardAxis(const Settings& s) {
  return s.lights.up == LightsUp::automatic ? 1 : static_cast<int>(s.lights.up);
}

/// Cosines between the world's axes and the upward direction in the middle of the window.
inline glm::dvec3 upwardness(const Snapshot& s) {
  const glm::dmat4 rows = glm::transpose(s.camera.clipFromEye * s.eyeFromWorld);
  glm::dvec3 up(rows[1]);
  for (int i = 0; i < 3; ++i) up[i] /= glm::length(glm::dvec3(s.eyeFromWorld[i]));
  const double length = glm::length(up);
  return length > 0 ? up / length : glm::dvec3(0, 1, 0);
}

}  // namespace gluray::scene
