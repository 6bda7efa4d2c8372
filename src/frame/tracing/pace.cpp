#include "frame/tracing/pace.h"

#include <algorithm>

namespace gluray::frame {

render::MovingRays Pace::rays() const {
  if (level_ == 0) return {1, true};
  return {1 << (level_ - 1), false};
}

void Pace::step(int by) {
  level_ = std::clamp(level_ + by, 0, kLevels - 1);
  slow_ = fast_ = 0;
}

void Pace::took(double seconds, double target) {
  constexpr double kTooSlow = 1.1, kFarTooSlow = 2;  // of the target
  constexpr int kSlowFrames = 2;                     // one may be an accident
  // The next level has two or four times as many rays; part of a frame's time does not depend on them.
  const double growth = level_ == 0 ? 2.5 : 1.8;
  slow_ = seconds > kTooSlow * target ? slow_ + 1 : 0;
  fast_ = seconds * growth < target ? fast_ + 1 : 0;
  if (slow_ >= kSlowFrames || (slow_ > 0 && seconds > kFarTooSlow * target)) {
    tried_ ? void(patience_.take()) : patience_.restart();
    tried_ = false;
    return step(-1);
  }
  if (level_ + 1 == kLevels || fast_ < patience_.next) return;
  tried_ = true;
  step(1);
}

}  // namespace gluray::frame
