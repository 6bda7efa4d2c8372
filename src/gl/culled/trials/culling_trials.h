// Decides by measurement whether culling a draw makes it faster, as EngineChoice decides for frames. The
// trials of all draws share a time budget (TrialBudget). Calls no OpenGL and reads no clock. GL thread.
#pragma once
#include "base/growing_interval.h"
#include "gl/trials/measurement.h"
#include "gl/trials/trial_budget.h"

#include <cstdint>

namespace gluray::gl {

class CullingTrials {
 public:
  enum class Way : uint8_t { plain, culled };
  struct Next {
    Way way = Way::plain;
    bool measured = false;  // finish all before and after; report the time by took()
  };

  /// How to make the next draw. `always`: culled, without measuring.
  Next nextDraw(bool always, TrialBudget& budget) {
    if (always) return {Way::culled, false};
    if (plain_ < 0) return {Way::plain, true};
    budget.earn(plain_, plain_);
    if (!isTrying()) {
      if (--hold_ > 0) return {better_, false};
      // The cost of plain draws may have changed since it was measured.
      plain_ = -1;
      return {Way::plain, true};
    }
    return budget.left() >= 0 ? Next{Way::culled, true} : Next{Way::plain, false};
  }

  /// Reports the time of a draw for which nextDraw() returned `measured`. `culled`: whether it was culled;
  /// false although `way` is `culled`: it could not be, and was made whole.
  void took(Way way, bool culled, double seconds, TrialBudget& budget) {
    if (way == Way::plain) return void((plain_ = seconds, culled_ = Measurement(kTries)));
    budget.spend(seconds - plain_);
    const bool ends = culled ? culled_.add(seconds) : culled_.fails(kTries);
    if (ends || culled_.seconds() > kHopeless * plain_)
      conclude(culled && culled_.seconds() < kGain * plain_);
  }
  bool pays() const { return better_ == Way::culled || isTrying(); }  // also true during trials

 private:
  static constexpr int kTries = 3;                    // culled draws that are measured
  static constexpr double kGain = 0.9;                // of the plain time: limit below which culling pays
  static constexpr double kHopeless = 1.5;            // of the plain time: ends the trial at once
  static constexpr int kHold = 64, kLongHold = 1024;  // draws until the next trial

  bool isTrying() const { return plain_ >= 0 && hold_ == 0; }
  void conclude(bool pays) {
    if (pays) again_.restart();
    hold_ = pays ? kLongHold : again_.take();
    better_ = pays ? Way::culled : Way::plain;
  }

  double plain_ = -1;  // seconds; negative: not measured
  Measurement culled_{kTries};
  int hold_ = 0;  // draws until the next trial
  GrowingInterval<int> again_{kHold, kLongHold};
  Way better_ = Way::plain;
};

}  // namespace gluray::gl
