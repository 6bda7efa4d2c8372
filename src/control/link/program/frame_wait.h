// Lets a request wait for a frame of the program: decides when to request a redraw, and when to give up.
// Control thread; times in seconds.
#pragma once
#include "settings/live/settings_source.h"

namespace gluray::control {

struct FrameWait {
  static constexpr double kPatience = 8;     // limit for a frame
  static constexpr double kQuiet = 0.1;      // without a frame for that long, the program is idle
  static constexpr double kAskAgain = 0.15;  // until the second request to draw; doubled each time

  double until = 0, wake = 0, pause = kAskAgain;

  /// For a request that arrives now. A program that is drawing is not requested to draw.
  FrameWait(const SettingsSource& source, double now) : until(now + kPatience), wake(now) {
    const double active = source.begun().active;
    if (active > 0 && now - active < kQuiet) wake = now + kQuiet;
  }
  bool isOver(double now) const { return now >= until; }
  /// Whether the program must be requested to draw now. True once each time.
  bool wakes(double now) {
    if (now < wake) return false;
    wake = now + pause, pause *= 2;
    return true;
  }
};

}  // namespace gluray::control
