// Corners of axis-aligned boxes. Any thread.
#pragma once
#include <glm/glm.hpp>

namespace gluray::scene {

/// Corner number `i`, from 0 to 7, of the box from `lower` to `upper`: bits 0, 1 and 2 of `i` choose `upper`
/// along x, y and z.
template <class T>
glm::vec<3, T> boxCorner(const glm::vec<3, T>& lower, const glm::vec<3, T>& upper, int i) {
  return {i & 1 ? upper.x : lower.x, i & 2 ? upper.y : lower.y, i & 4 ? upper.z : lower.z};
}

}  // namespace gluray::scene
