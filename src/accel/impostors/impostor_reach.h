// Extents of impostors around their centres, for the bounding boxes in their BLAS. Any thread.
#pragma once
#include "scene/snapshot.h"

#include <glm/glm.hpp>

namespace gluray::accel {

/// Extent of an instance's impostors about their centres, in object space. Rounded up so that it stays equal
/// while the camera moves, although the matrices then vary by rounding.
struct ImpostorReach {
  glm::vec3 perRadius{0};  // along each coordinate axis, for radius 1
  glm::mat3 alongAxis{0};  // maps half of Mesh::axes to half a cylinder's axis in object space
  glm::vec3 perLength{0};  // rounding error of alongAxis, for length 1
  glm::vec3 further{0};    // added to both, independent of radius and length
  bool operator==(const ImpostorReach&) const = default;
};

ImpostorReach reachOf(const scene::Instance&, const scene::Camera&);

/// Extent of an instance's beads or tubes about their points and lines, in object space; valid for every
/// camera that is at least as far away.
ImpostorReach reachInPixels(const scene::Instance&, const scene::Camera&);

/// Extent of splats, in proportion to their radius.
ImpostorReach reachOfSplats(const scene::Instance&, const scene::Camera&);

/// Upper bound of the largest stretch of a matrix; exact for rotations and uniform scales.
double largestStretch(const glm::dmat3&);

/// Rounds up to a power of 2^(1/64), so that small rounding differences seldom change the result.
float roundedUp(double length);

}  // namespace gluray::accel
