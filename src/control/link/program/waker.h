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
  static constexpr double kLook = 0.3;    // until it is clear what an exposure has done
  static constexpr double kPoll = 0.02;   // between two looks meanwhile
  static constexpr double kWider = 0.1;   // before windows have their own size again
  static constexpr int kMaxFailures = 2;  // sizes that made nothing draw: no more are told

  Waker(ControlledProgram& program, const SettingsSource& source) : program_(program), source_(source) {}
  /// Windows have their own size afterwards.
  ~Waker() {
    if (step_ == Step::wider) program_.tellSize(false);
  }
  Waker(const Waker&) = delete;
  Waker& operator=(const Waker&) = delete;

  /// The program shall draw; passed() asks it to.
  void wake() noexcept { wanted_ = true; }
  void passed(double now);
  double nextDue(double now) const;
  /// Whether frames that are shown now may be for windows of another size.
  bool widens() const { return step_ == Step::wider; }

 private:
  enum class Step {
    rest,
    exposed,  // what that does is looked at
    wider,    // windows seem one pixel wider
    told      // their own size: what that does is looked at
  };
  void begin(double now);
  void seeExposure(double now);
  void go(Step step, double due) { step_ = step, due_ = due; }
  void tellWider(double now);
  bool drew();

  ControlledProgram& program_;
  const SettingsSource& source_;
  bool wanted_ = false;
  bool onlyShows_ = false;  // exposed, the program shows again what it drew
  int failures_ = 0;
  Step step_ = Step::rest;
  double due_ = 0;
  uint64_t frame_ = 0, draws_ = 0;  // when it was asked
};

}  // namespace gluray::control
