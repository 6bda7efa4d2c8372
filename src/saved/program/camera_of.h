// Cameras between the launcher and the engine. Any thread.
#pragma once
#include "saved/program/render.h"
#include "saved/shot/view_camera.h"

namespace gluray::saved {

inline ViewCamera cameraOf(const GlurayCamera& c) {
  const auto vector = [](const double(&v)[3]) { return glm::dvec3(v[0], v[1], v[2]); };
  return {vector(c.position), vector(c.focalPoint), vector(c.up), c.viewAngle, c.parallelScale};
}

inline GlurayCamera cameraOf(const ViewCamera& c) {
  return {{c.position.x, c.position.y, c.position.z},
          {c.focalPoint.x, c.focalPoint.y, c.focalPoint.z},
          {c.up.x, c.up.y, c.up.z},
          c.viewAngle,
          c.parallelScale};
}

}  // namespace gluray::saved
