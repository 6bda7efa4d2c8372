// Distinguishes frames of animations from single images in programs without a visible window (setting
// refine.offscreen = animated). A part of FrameClock, GL thread; the caller passes times.
#pragma once
#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace gluray::gl {

class OffscreenAnimation {
 public:
  /// Seconds without an image after which the next one counts as a single image.
  static constexpr double kPause = 0.5;

  /// Whether a view's frame, new or continued, belongs to an animation: it follows an image of its size
  /// without a pause, or a larger image of the same shape exists, because some programs reduce images while
  /// the camera turns. Throws std::bad_alloc.
  bool isAnimated(glm::ivec2 size, uint64_t frame, double now);
  /// Reports that the image of the last isAnimated() is complete.
  void drawn(double now) {
    if (!views_.empty()) views_.back().drawn = now;
  }

 private:
  struct View {
    glm::ivec2 size;
    uint64_t frame;
    bool animated;
    double drawn;
  };
  bool isReduced(glm::ivec2 size) const;
  std::vector<View> views_;  // one for each size; the last is that of the last isAnimated()
};

}  // namespace gluray::gl
