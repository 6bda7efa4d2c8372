// Time budget for trials of culling or tracing: a small fraction of the program's drawing time. Calls no
// OpenGL and reads no clock. GL thread.
#pragma once
#include <algorithm>

namespace gluray::gl {

class TrialBudget {
 public:
  /// Share of the program's drawing time that trials may cost.
  static constexpr double kShare = 0.02;

  /// Adds a share of `seconds`, the time of what was drawn without trials. The budget stays below `most`
  /// seconds.
  void earn(double seconds, double most) { add(kShare * seconds, most); }
  /// Adds `seconds` to the budget, which stays below `most`.
  void add(double seconds, double most) { left_ = std::min(left_ + seconds, std::max(left_, most)); }
  /// Charges a trial that took `seconds` longer than the same draws without it.
  void spend(double seconds) { left_ -= std::max(seconds, 0.0); }
  /// Seconds left; negative: a trial took more than was left.
  double left() const { return left_; }

 private:
  double left_ = 0;
};

}  // namespace gluray::gl
