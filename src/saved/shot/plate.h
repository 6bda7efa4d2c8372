// What a window showed beside traced surfaces: the background, and what the program drew over the surfaces.
// Immutable; any thread.
#pragma once
#include "saved/sections/saved_picture.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace gluray::saved {

class Plate {
 public:
  /// Nothing: transparent everywhere.
  Plate() = default;
  /// `traced`: premultiplied colours of the traced surfaces in the window, one per pixel of `shown`. `exact`:
  /// the window shows these. Otherwise it may have changed them by noise and by filters that mix neighbours,
  /// such as antialiasing.
  Plate(const SavedPicture& shown, const std::vector<uint32_t>& traced, bool exact);

  bool empty() const { return background_.empty(); }
  /// Whether something stands over surfaces.
  bool hasOverlays() const { return overlays_ > 0; }
  /// The background at a pixel of the window, RGBA8: its own colour where no surface is.
  uint32_t windowBackgroundAt(glm::ivec2 pixel) const;
  /// The window's own pixel, RGBA8, if it differs from `color` by rounding alone; otherwise `color`.
  uint32_t roundedAsShown(glm::ivec2 pixel, uint32_t color) const;
  /// The background at a place of the window, in pixels; beside the window the nearest one. RGBA8. Behind
  /// and beside surfaces it is that of the nearest pixel away from them: filters of the program mix both at
  /// edges.
  uint32_t backgroundAt(const glm::dvec2& place) const;
  /// What stands over surfaces there: premultiplied RGBA8.
  uint32_t overlayAt(const glm::dvec2& place) const;
  /// The same as floats, without the rounding of what lies between pixels.
  glm::vec4 wideBackgroundAt(const glm::dvec2& place) const;
  glm::vec4 wideOverlayAt(const glm::dvec2& place) const;
  /// Replaces the background by the middle colour of each row: without text and axes that stand before it.
  void clearBackground();

 private:
  size_t indexOf(glm::ivec2 pixel) const {
    return static_cast<size_t>(pixel.y) * static_cast<size_t>(width_) + static_cast<size_t>(pixel.x);
  }
  bool isOverlay(const std::vector<uint32_t>& traced, glm::ivec2 pixel, bool exact) const;
  void fillBehind(std::vector<uint8_t> known);
  std::vector<uint8_t> awayFromSurfaces() const;

  int width_ = 0, height_ = 0;
  size_t overlays_ = 0;
  std::vector<uint32_t> shown_, background_, overlay_;
  std::vector<uint8_t> isBackground_;
};

}  // namespace gluray::saved
