// Chooses the number of rays of moving frames to reach the frame rate of the setting fps. Called by
// frame::Renderer, separately for each view; the caller passes times.
#pragma once
#include "base/growing_interval.h"
#include "render/moving/moving_frame.h"

namespace gluray::frame {

/// Reduces the rays if frames are too slow, and increases them if the expected time is short enough. Each
/// time that more rays were too slow, it waits longer before it tries again.
class Pace {
 public:
  /// Rays of the next frame.
  render::MovingRays rays() const;
  /// Reports the time of a frame with these rays in seconds, without building structures; `target`: seconds.
  void took(double seconds, double target);

 private:
  void step(int by);

  static constexpr int kFirst = 1, kLevels = 6;  // one ray a pixel; a quarter, 1, 2, 4, 8, 16
  int level_ = kFirst;
  int slow_ = 0, fast_ = 0;                // frames in a row
  GrowingInterval<int> patience_{4, 256};  // fast frames before an increase
  bool tried_ = false;                     // the last step was an increase
};

}  // namespace gluray::frame
