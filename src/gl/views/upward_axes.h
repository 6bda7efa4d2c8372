// Finds the upward axis of each view from the program's camera (lights.up = auto). A part of ViewScenes, GL
// thread.
#pragma once
#include "gl/batch/batch.h"
#include "scene/upward_axis.h"

#include <vector>

namespace gluray::gl {

class UpwardAxes {
 public:
  /// The axis that points most upwards (or downwards) in the view's first frame. A later frame changes it
  /// only where another axis is within 30 degrees of the vertical: turning the camera does not turn the
  /// light.
  LightsUp axisOf(const BatchKey& key, const scene::Snapshot& s) {
    const glm::dvec3 up = glm::abs(scene::upwardness(s));
    const int most = up.x > up.y ? (up.x > up.z ? 0 : 2) : (up.y >= up.z ? 1 : 2);
    constexpr double kClearly = 0.866;  // cosine of 30 degrees
    for (View& view : views_)
      if (view.framebuffer == key.framebuffer && view.viewport == key.viewport) {
        if (up[most] > kClearly) view.axis = most;
        return LightsUp(view.axis);
      }
    if (views_.size() >= kMaxViews) views_.erase(views_.begin());
    views_.push_back({key.framebuffer, key.viewport, most});
    return LightsUp(most);
  }
  void clear() { views_.clear(); }

 private:
  static constexpr size_t kMaxViews = 64;
  struct View {
    GLuint framebuffer;
    glm::ivec4 viewport;
    int axis;
  };
  std::vector<View> views_;  // the oldest one first
};

}  // namespace gluray::gl
