// What a program shows, as a scene that can be saved. Control thread.
#pragma once
#include "gl/objects/shown_frames.h"
#include "intercept/control/shown_scene.h"
#include "saved/scene/saved_scene.h"

#include <glm/glm.hpp>

#include <optional>

namespace gluray::intercept {

/// What a frame shows, without the window's pixels.
struct ShownAsSaved {
  saved::SavedScene scene;
  /// Where the window shows it: x, y, width and height, pixels from the lower left corner. Toolkits draw
  /// views into framebuffer objects that fill parts of their windows: then that part. None: not known.
  std::optional<glm::ivec4> box;
};
ShownAsSaved shownAsSaved(const gl::ShownFrame& frame, const ShownWindowPlaces& window);

}  // namespace gluray::intercept
