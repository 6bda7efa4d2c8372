// Limit of what the trials of a context may cost in all: a share of the time that it has drawn, and at first
// of some seconds (adr/0122). Calls no OpenGL and reads no clock. GL thread.
#pragma once
#include <algorithm>

namespace gluray::gl {

class TrialLimit {
 public:
  static constexpr double kShare = 0.05;
  static constexpr double kFirstSeconds = 10;

  /// Reports `seconds` of drawing: what frames take in the way that is in use, without trials.
  void drew(double seconds) { drawn_ += seconds; }
  /// Reports a frame of a trial that took `seconds` longer than one without it.
  void spend(double seconds) { spent_ += std::max(seconds, 0.0); }
  /// Whether trials may cost `seconds` more. Nothing is always affordable.
  bool affords(double seconds) const {
    return seconds <= 0 || spent_ + seconds <= kShare * std::max(drawn_, kFirstSeconds);
  }

 private:
  double drawn_ = 0, spent_ = 0;
};

}  // namespace gluray::gl
