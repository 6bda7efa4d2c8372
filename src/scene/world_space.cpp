#include "scene/world_space.h"

#include <cmath>

namespace gluray::scene {

bool isPlaceable(const glm::mat4& m) {
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 4; ++r) {
      if (!std::isfinite(m[c][r])) return false;
    }
  }
  if (m[0][3] != 0 || m[1][3] != 0 || m[2][3] != 0 || m[3][3] != 1) return false;
  const glm::dvec3 x(m[0]), y(m[1]), z(m[2]);
  const double volume = std::abs(glm::dot(glm::cross(x, y), z));
  return volume > 1e-6 * glm::length(x) * glm::length(y) * glm::length(z) && volume > 1e-36;
}

}  // namespace gluray::scene
