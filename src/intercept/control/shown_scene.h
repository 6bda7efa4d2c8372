// The views of a shown frame and their contents, for calls about the program's scene. Control thread.
#pragma once
#include "gl/objects/shown_frames.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace gluray::intercept {

/// One camera and viewport, and the batches that show something there, in drawing order. Its world space is
/// that of its first batch.
struct ShownView {
  std::vector<const gl::ShownBatch*> batches;
  const scene::Snapshot& first() const { return *batches.front()->snapshot; }
  /// The matrix from the world space of one of its batches to the view's world space.
  glm::dmat4 viewFromWorld(const scene::Snapshot& batch) const;
};

/// The views of a frame, in drawing order.
std::vector<ShownView> viewsOf(const gl::ShownFrame& frame);

/// The surface point at a position.
struct ShownPoint {
  size_t view = 0;  // index in the views
  const scene::Snapshot* snapshot = nullptr;
  const scene::Instance* instance = nullptr;
  glm::dvec3 point, normal;  // in the snapshot's eye space
  glm::dvec2 share;          // of the view's width and height, from its lower left corner
};

/// Size of the window, and the rectangles in which it may show framebuffer objects.
struct ShownWindowPlaces {
  glm::ivec2 size{0};              // {0, 0}: unknown
  std::vector<glm::ivec4> places;  // ShownFrames::places()
};
/// The surface point that the window shows at `at`, in pixels from the lower left corner. Later views cover
/// earlier ones. Nullopt if no surface is there. Throws std::runtime_error with a one-line message, also if
/// it is unknown where the window shows the views.
std::optional<ShownPoint> pointAt(const std::vector<ShownView>& views, const glm::dvec2& at,
                                  const ShownWindowPlaces& window);
/// Position of the framebuffer's lower left corner in the window. A framebuffer object fills the whole
/// window, or the only rectangle of its size. Nullopt if the position is unknown.
std::optional<glm::ivec2> placeOf(const std::vector<ShownView>& views, uint32_t framebuffer,
                                  const ShownWindowPlaces& window);
/// Width and height of a framebuffer, estimated from what is drawn into it.
glm::ivec2 extentOf(const std::vector<ShownView>& views, uint32_t framebuffer);
/// Size of the smallest window that contains the views.
glm::ivec2 extentOf(const std::vector<ShownView>& views);

}  // namespace gluray::intercept
