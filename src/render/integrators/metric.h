// The space that light is computed in: eye space, where lengths and angles are what the viewer sees, whatever
// the world is scaled by. Rays go back to world space for their queries; t stays the same. Made once a frame.
#pragma once
#include "render/frame_data/frame_data.h"

#include <glm/glm.hpp>

namespace gluray::render {

struct Metric {
  glm::mat4 worldFromEye{1}, eyeFromWorld{1};
  glm::dvec4 away{0, 0, -1, 0};  // the direction away from the viewer at point p is away.xyz - away.w * p
  glm::vec3 axes{1};             // lengths of the world's axes in eye space
  float diagonal = 1;            // of the bounds of all that light meets: the same however the view turns

  /// Throws std::runtime_error where the modelview matrix cannot be inverted.
  explicit Metric(const FrameData&);
};

}  // namespace gluray::render
