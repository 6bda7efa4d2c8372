// Position and size of the ground (setting `ground`). Made once a frame; any thread.
#pragma once
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <optional>

namespace gluray::render {

struct GroundPlace {
  /// From the ground's object space, in which it is the square [-half, half]^2 at z = 0 and z points up.
  glm::dmat4 worldFromObject{1};
  /// A power of two, so that the mesh does not change with small changes of the scene's bounds, and matrix
  /// elements are about 1 for scenes of any size.
  float half = 1;
};

/// Places the ground settings.ground.offset below the bounds of the snapshot and its secondary scene,
/// perpendicular to the upward axis of the view's first object (settings.lights.up), with width
/// settings.ground.size. None if there are no bounds.
std::optional<GroundPlace> placeGround(const scene::Snapshot&);

}  // namespace gluray::render
