// Finds the visible surface at a window position. Any thread.
#pragma once
#include "frame/tracing/renderer.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <optional>
#include <string>

namespace gluray::frame {

struct Picked {
  size_t instance = 0;       // index of Snapshot::instances
  glm::dvec3 point, normal;  // eye space; the normal has unit length, on the viewer's side
  float depth = 1;           // window depth, to compare images of one view
};

/// Returns the nearest surface at a window position in pixels from the lower left corner; none if there is no
/// surface, or if the position is outside of the snapshot's region. Ignores surfaces hidden from the camera;
/// includes blended surfaces. Waits for the frame that is being traced. Throws std::runtime_error.
std::optional<Picked> pick(Renderer& renderer, const scene::Snapshot& snapshot, const glm::dvec2& at);

}  // namespace gluray::frame
