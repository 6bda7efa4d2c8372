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
  /// `traced`: premultiplied colours of the traced surfaces in the window, one per pixel of `shown`.
  Plate(const SavedPicture& shown, const std::vector<uint32_t>& traced);

  bool empty() const { return background_.empty(); }
  /// Whether something stands over surfaces.
  bool hasOverlays() const { return overlays_ > 0; }
  /// The background at a place of the window, in pixels; beside the window the nearest one. RGBA8. Behind
  /// surfaces it is that of the nearest pixel without them.
  uint32_t backgroundAt(const glm::dvec2& place) const;
  /// What stands over surfaces there: premultiplied RGBA8.
  uint32_t overlayAt(const glm::dvec2& place) const;
  /// The same as floats, without the rounding of what lies between pixels.
  glm::vec4 wideBackgroundAt(const glm::dvec2& place) const;
  glm::vec4 wideOverlayAt(const glm::dvec2& place) const;
  /// Replaces the background by the middle colour of each row: without text and axes that stand before it.
  void clearBackground();

 private:
  void fillBehind(std::vector<uint8_t> known);

  int width_ = 0, height_ = 0;
  size_t overlays_ = 0;
  std::vector<uint32_t> background_, overlay_;
  std::vector<uint8_t> isBackground_;
};

}  // namespace gluray::saved
