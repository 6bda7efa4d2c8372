// Where structures are placed in the world, as World and its light need it. Private to accel/, one thread.
#pragma once
#include "accel/tlas.h"

#include <glm/glm.hpp>

#include <vector>

namespace gluray::accel {

/// Whether a TLAS may stay as it is for instances that a camera sees: the structures are the same, and
/// transforms are equal up to the rounding of float matrices.
bool stayPlaced(const glm::dmat4& eyeFromWorld, const Tlas&, const std::vector<PlacedBlas>& placed);

struct Bounds {
  glm::vec3 lower{0}, upper{0};
  bool empty() const { return !(lower.x <= upper.x && lower.y <= upper.y && lower.z <= upper.z); }
};
Bounds boundsOf(RTCSceneTy*);
/// The box in another space around the boxes of instances.
Bounds boundsIn(const glm::dmat4& spaceFromWorld, const std::vector<PlacedBlas>&);

}  // namespace gluray::accel
