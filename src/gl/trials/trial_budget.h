// Time budget for trials of culling or tracing: a small fraction of the program's drawing time. Calls no
// OpenGL and reads no clock. GL thread.
#pragma once
#include <algorithm>

namespace gluray::gl {

class TrialBudget {
 public:
  /// Of the time in which a program draws.
  static constexpr double kShare = 0.02;

  /// Something was drawn that takes so many seconds without trials. At most `most` seconds are saved up.
  void earn(double seconds, double most) { add(kShare * seconds, most); }
  /// Seconds without work for them. At most `most` are saved up.
  void add(double seconds, double most) { left_ = std::min(left_ + seconds, std::max(left_, most)); }
  /// A trial took so many seconds more than what was drawn takes without it.
  void spend(double seconds) { left_ -= std::max(seconds, 0.0); }
  /// Seconds; negative: a trial took more than was left.
  double left() const { return left_; }

 private:
  double left_ = 0;
};

}  // namespace gluray::gl
