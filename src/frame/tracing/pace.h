// Chooses how many rays moving frames take, so that they come as often as the setting fps asks. Called by
// frame::Renderer, for each view on its own; times are handed in.
#pragma once
#include "render/moving/moving_frame.h"

namespace gluray::frame {

/// Goes to fewer rays when frames are too slow, and to more when it expects these to be fast enough. Each
/// time that more rays proved too slow, it waits longer before it tries them again.
class Pace {
 public:
  /// Rays of the next frame.
  render::MovingRays rays() const;
  /// A frame with these rays took so many seconds, without building structures; `target`: seconds.
  void took(double seconds, double target);

 private:
  void step(int by);

  static constexpr int kFirst = 1, kLevels = 6;            // one ray a pixel; a quarter, 1, 2, 4, 8, 16
  static constexpr int kPatience = 4, kMaxPatience = 256;  // frames
  int level_ = kFirst;
  int slow_ = 0, fast_ = 0;  // frames in a row
  int patience_ = kPatience;
  bool tried_ = false;  // the last step was one up
};

}  // namespace gluray::frame
