// Lets a request wait for a frame of the program: decides when to ask the program to redraw, and when to give
// up. Control thread; times in seconds.
#pragma once
#include "settings/live/settings_source.h"

namespace gluray::control {

struct FrameWait {
  static constexpr double kPatience = 8;     // for a frame
  static constexpr double kQuiet = 0.1;      // without a frame: the program draws nothing
  static constexpr double kAskAgain = 0.15;  // until the second request to draw; then twice as long each time

  double until = 0, wake = 0, pause = kAskAgain;

  /// Of a request that comes now. A program that draws is not asked to.
  FrameWait(const SettingsSource& source, double now) : until(now + kPatience), wake(now) {
    const double active = source.begun().active;
    if (active > 0 && now - active < kQuiet) wake = now + kQuiet;
  }
  bool isOver(double now) const { return now >= until; }
  /// Whether the program is to be asked to draw now; says so once each time.
  bool wakes(double now) {
    if (now < wake) return false;
    wake = now + pause, pause *= 2;
    return true;
  }
};

}  // namespace gluray::control
