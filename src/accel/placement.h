// Compares placements of structures, and computes their bounds, for World and LightScene. Private to accel/,
// one thread.
#pragma once
#include "accel/rays/bounds.h"
#include "accel/tlas.h"

#include <glm/glm.hpp>

#include <vector>

namespace gluray::accel {

/// Whether a TLAS is still valid for these instances: equal structures, and transforms that are equal up to
/// the rounding of float matrices.
bool stayPlaced(const glm::dmat4& eyeFromWorld, const Tlas&, const std::vector<PlacedBlas>& placed);

Bounds boundsOf(RTCSceneTy*);
/// Bounding box of the instances' boxes in another space.
Bounds boundsIn(const glm::dmat4& spaceFromWorld, const std::vector<PlacedBlas>&);

}  // namespace gluray::accel
