// Distinguishes frames of animations from single images in programs without a visible window (setting
// refine.offscreen = animated). A part of FrameClock, GL thread; the caller passes times.
#pragma once
#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace gluray::gl {

class OffscreenAnimation {
 public:
  /// Seconds without an image after which the next one is a single one.
  static constexpr double kPause = 0.5;

  /// Whether a view's frame, which begins or goes on, is one of an animation: it follows an image of its
  /// size without a pause, or there has been a larger one of the same shape, as where programs reduce
  /// images while the camera turns. Throws std::bad_alloc.
  bool isAnimated(glm::ivec2 size, uint64_t frame, double now);
  /// The image that was asked about last is there.
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
  std::vector<View> views_;  // by size; the one that was asked about last is the last one
};

}  // namespace gluray::gl
