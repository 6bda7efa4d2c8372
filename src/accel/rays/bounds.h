// An axis-aligned bounding box. Any thread.
#pragma once
#include <glm/glm.hpp>

namespace gluray::accel {

/// Empty if a side has a negative length.
struct Bounds {
  glm::vec3 lower{0}, upper{0};
  bool empty() const { return !(lower.x <= upper.x && lower.y <= upper.y && lower.z <= upper.z); }
};

}  // namespace gluray::accel
