// Makes an idle program redraw its scene. Most programs redraw when a window is exposed. Toolkits that cache
// images of their views only show these again, and redraw when a window's size seems to change. The waker
// tries both methods. Control thread; times in seconds.
#pragma once
#include "control/link/program/controlled_program.h"
#include "settings/live/settings_source.h"

#include <cstdint>

namespace gluray::control {

class Waker {
 public:
  static constexpr double kLook = 0.3;    // time in which an exposure shows its effect
  static constexpr double kPoll = 0.02;   // interval of checks meanwhile
  static constexpr double kWider = 0.1;   // until windows are sent their own size again
  static constexpr double kCalm = 1;      // from then on until it has drawn in that size
  static constexpr int kMaxFailures = 2;  // after so many ineffective sizes, no more are sent

  Waker(ControlledProgram& program, const SettingsSource& source) : program_(program), source_(source) {}
  /// Sends windows their own size, if they were last sent another one.
  ~Waker() {
    if (step_ == Step::wider) program_.tellSize(false);
  }
  Waker(const Waker&) = delete;
  Waker& operator=(const Waker&) = delete;

  /// Requests that the program draws; passed() does it.
  void wake() noexcept { wanted_ = true; }
  void passed(double now);
  double nextDue(double now) const;
  /// Whether frames shown now may be for windows of another size.
  bool widens() const { return step_ == Step::wider; }
  /// Whether what the program drew last may be for windows of another size.
  bool disturbs(double now) const { return widens() || now < calm_; }

 private:
  enum class Step {
    rest,
    exposed,  // windows were exposed; waits for the effect
    wider,    // windows were sent a size one pixel wider
    told      // windows were sent their own size; waits for the effect
  };
  void begin(double now);
  void seeExposure(double now);
  void go(Step step, double due) { step_ = step, due_ = due; }
  void tellWider(double now);
  bool drew();

  ControlledProgram& program_;
  const SettingsSource& source_;
  bool wanted_ = false;
  bool onlyShows_ = false;  // when exposed, the program only shows a cached image
  int failures_ = 0;
  Step step_ = Step::rest;
  double due_ = 0, calm_ = 0;
  uint64_t frame_ = 0, draws_ = 0;  // when it was requested to draw
};

}  // namespace gluray::control
