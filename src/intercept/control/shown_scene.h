// The views of a shown frame and their contents, for calls about the program's scene. Control thread.
#pragma once
#include "gl/objects/shown_frames.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace gluray::intercept {

/// One camera and viewport, and the batches that show something there, in the order of drawing. Its world is
/// that of its first batch.
struct ShownView {
  std::vector<const gl::ShownBatch*> batches;
  const scene::Snapshot& first() const { return *batches.front()->snapshot; }
  /// To the view's world from that of one of its batches.
  glm::dmat4 viewFromWorld(const scene::Snapshot& batch) const;
};

/// The views in the order of drawing.
std::vector<ShownView> viewsOf(const gl::ShownFrame& frame);

/// What is at a position.
struct ShownPoint {
  size_t view = 0;  // index of the views
  const scene::Snapshot* snapshot = nullptr;
  const scene::Instance* instance = nullptr;
  glm::dvec3 point, normal;  // in the snapshot's eye space
  glm::dvec2 share;          // of the view's width and height, from its lower left corner
};

/// What the window shows at a position in pixels from its lower left corner; views that are drawn later cover
/// others. Throws std::runtime_error with one line, also where it is not known where the window shows the
/// views.
struct ShownWindowPlaces {
  glm::ivec2 size{0};              // of the window, {0, 0}: not known
  std::vector<glm::ivec4> places;  // ShownFrames::places()
};
std::optional<ShownPoint> pointAt(const std::vector<ShownView>& views, const glm::dvec2& at,
                                  const ShownWindowPlaces& window);
/// The smallest window that the views fit into.
glm::ivec2 extentOf(const std::vector<ShownView>& views);

}  // namespace gluray::intercept
