// Which surface a snapshot shows at a position of its window. Any thread.
#pragma once
#include "frame/tracing/renderer.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <optional>
#include <string>

namespace gluray::frame {

struct Picked {
  size_t instance = 0;       // index of Snapshot::instances
  glm::dvec3 point, normal;  // eye space; the normal is of unit length, on the viewer's side
  float depth = 1;           // window depth, to compare pictures of one view
};

/// The nearest surface at a window position in pixels, from the lower left corner; none: nothing is there, or
/// it lies outside the snapshot's region. Surfaces that rules hide from the camera are not met, those that
/// the program blends are. Waits for the frame that is being traced. Throws std::runtime_error.
std::optional<Picked> pick(Renderer& renderer, const scene::Snapshot& snapshot, const glm::dvec2& at);

}  // namespace gluray::frame
