// History of visibility for the following frames of an animation, per view. Owned by frame::Renderer,
// which traces one frame at a time.
#pragma once
#include "render/integrators/light_visibility.h"
#include "render/moving/moving_frame.h"

#include <list>
#include <memory>

namespace gluray::render {

/// The buffers of one view.
class LightHistory {
 public:
  /// Prepares the buffers for a frame with this integrator, and fills `moving`. Uses earlier frames only if
  /// the view's size, the settings and the lights are equal; reduces their weight if surfaces have moved or
  /// changed. Throws std::bad_alloc.
  void begin(const FrameData&, const VisibilityIntegrator&, MovingFrame& moving);
  /// The frame is complete: the next frame may use it.
  void finish() { now_ = 1 - now_, ++index_, known_ = true; }
  /// The frame was abandoned: the next frame uses the same history as this one.
  void abandon() { known_ = same_; }
  /// Forgets earlier frames.
  void forget() { known_ = false; }
  uint32_t index() const { return index_; }
  size_t bytes() const;

 private:
  struct Frame {
    VisibilityBuffer visibility;
    PixelSpace space;
    Placement placement;
    std::vector<glm::vec3> lights;  // VisibilityIntegrator::lightPlaces()
  };
  Frame frames_[2];
  HitBuffer hits_;
  int now_ = 0;  // frames_[now_]: the one to be traced
  uint32_t index_ = 0;
  bool known_ = false;
  bool same_ = false;  // the frame before shows the same as the one to be traced
  std::vector<float> meaning_;
  Channels channels_;
  Settings settings_;
  scene::Region region_;
};

/// Histories of the most recently traced views.
class LightHistories {
 public:
  static constexpr size_t kMax = 4;
  /// Throws std::bad_alloc.
  LightHistory& historyOf(uint64_t view);
  void clear() { views_.clear(); }
  size_t bytes() const;

 private:
  struct View {
    uint64_t view;
    LightHistory history;
  };
  std::list<View> views_;  // the last one used first
};

}  // namespace gluray::render
