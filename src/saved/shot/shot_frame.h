// Where a picture of any size shows what a window showed. Any thread.
#pragma once
#include "saved/scene/saved_scene.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace gluray::saved {

/// What becomes of the view where the picture has another aspect ratio than the window.
enum class Fit : uint8_t {
  all,     // all of it is in the picture; a view that fills the window shows more at two sides
  crop,    // it fills the picture, and two sides are cut off
  stretch  // it is distorted
};

/// The pixels that both have; none: without width or height.
scene::Region common(const scene::Region& a, const scene::Region& b);

/// Maps the window to the picture. Pixels, from the lower left corners.
class ShotFrame {
 public:
  ShotFrame(glm::ivec2 window, glm::ivec2 size, Fit fit);

  glm::ivec2 size() const { return size_; }
  glm::dvec2 scale() const { return scale_; }
  /// Whether pictures are the window's pixels.
  bool isWindow() const { return size_ == window_; }
  glm::dvec2 pictureOf(const glm::dvec2& window) const { return window * scale_ + corner_; }
  glm::dvec2 windowOf(const glm::dvec2& picture) const { return (picture - corner_) / scale_; }

  /// The batch as the picture shows it. A viewport that fills the window fills the picture. Its pixels have
  /// one sample of the framebuffer, unless isWindow(). Sizes in pixels grow with the picture.
  scene::Snapshot placed(const SavedBatch& batch) const;

 private:
  glm::ivec2 window_, size_;
  glm::dvec2 scale_, corner_;
};

}  // namespace gluray::saved
