// Light is computed in eye space, so that lengths and angles do not depend on the scaling of the world. Ray
// queries are transformed to world space with equal t. Made once a frame.
#pragma once
#include "render/frame_data/frame_data.h"

#include <glm/glm.hpp>

namespace gluray::render {

struct Metric {
  glm::mat4 worldFromEye{1}, eyeFromWorld{1};
  glm::dvec4 away{0, 0, -1, 0};  // the direction away from the viewer at point p is away.xyz - away.w * p
  glm::vec3 axes{1};             // lengths of the world's axes in eye space
  float diagonal = 1;            // of the bounds of the scene: independent of the viewing direction

  /// Throws std::runtime_error where the modelview matrix cannot be inverted.
  explicit Metric(const FrameData&);
};

}  // namespace gluray::render
