// Where structures are placed in the world, as World and its light need it. Private to accel/, one thread.
#pragma once
#include "accel/rays/bounds.h"
#include "accel/tlas.h"

#include <glm/glm.hpp>

#include <vector>

namespace gluray::accel {

/// Whether a TLAS may stay as it is for instances that a camera sees: the structures are the same, and
/// transforms are equal up to the rounding of float matrices.
bool stayPlaced(const glm::dmat4& eyeFromWorld, const Tlas&, const std::vector<PlacedBlas>& placed);

Bounds boundsOf(RTCSceneTy*);
/// The box in another space around the boxes of instances.
Bounds boundsIn(const glm::dmat4& spaceFromWorld, const std::vector<PlacedBlas>&);

}  // namespace gluray::accel
