// Where the setting `ground` puts a ground. Made once a frame; any thread.
#pragma once
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <optional>

namespace gluray::render {

struct GroundPlace {
  /// From the ground's object space, in which it is the square [-half, half]^2 at z = 0 and z points up.
  glm::dmat4 worldFromObject{1};
  /// A power of two, so that the mesh stays the same while the scene's bounds change little, and the
  /// matrix's elements are about 1 for scenes of any size.
  float half = 1;
};

/// Below the bounds of all that the snapshot and its surroundings hold, across the upward axis of the view's
/// first object (settings.lights.up), as far below as settings.ground.offset says and as wide as .size.
/// Nothing where there are no bounds.
std::optional<GroundPlace> placeGround(const scene::Snapshot&);

}  // namespace gluray::render
