// Decides by measurement whether culling a draw makes it faster, as EngineChoice decides for frames. The
// trials of all draws share a time budget (TrialBudget). Calls no OpenGL and reads no clock. GL thread.
#pragma once
#include "gl/trials/trial_budget.h"

#include <algorithm>
#include <cstdint>

namespace gluray::gl {

class CullingTrials {
 public:
  enum class Way : uint8_t { plain, culled };
  struct Next {
    Way way = Way::plain;
    bool measured = false;  // finish all before and after; report the time by took...()
  };

  /// How to make the next draw. `always`: culled, without measuring.
  Next nextDraw(bool always, TrialBudget& budget) {
    if (always) return {Way::culled, false};
    if (plain_ < 0) return {Way::plain, true};
    budget.earn(plain_, plain_);
    if (triesLeft_ == 0) {
      if (--hold_ > 0) return {better_, false};
      // The cost of plain draws may have changed since it was measured.
      plain_ = -1;
      return {Way::plain, true};
    }
    return budget.left() >= 0 ? Next{Way::culled, true} : Next{Way::plain, false};
  }

  /// Reports the time of a plain draw.
  void tookPlain(double seconds) {
    plain_ = seconds, culled_ = -1;
    triesLeft_ = kTries, vainLeft_ = kTries;
  }
  /// Reports the time of a draw for which nextDraw() returned `culled`. `culled`: whether it was culled, or
  /// else made whole because it could not be culled.
  void tookCulled(bool culled, double seconds, TrialBudget& budget) {
    budget.spend(seconds - plain_);
    if (!culled) {
      if (--vainLeft_ == 0) conclude(false);
      return;
    }
    culled_ = culled_ < 0 ? seconds : std::min(culled_, seconds);
    if (culled_ > kHopeless * plain_) return conclude(false);
    if (--triesLeft_ == 0) conclude(culled_ < kGain * plain_);
  }
  bool pays() const { return better_ == Way::culled || triesLeft_ > 0; }  // also true during trials

 private:
  static constexpr int kTries = 3;                    // culled draws that are measured
  static constexpr double kGain = 0.9;                // of the plain time: limit below which culling pays
  static constexpr double kHopeless = 1.5;            // of the plain time: ends the trial at once
  static constexpr int kHold = 32, kLongHold = 1024;  // draws until the next trial

  void conclude(bool pays) {
    triesLeft_ = 0;
    interval_ = pays ? kHold : std::min(2 * interval_, kLongHold);
    hold_ = pays ? kLongHold : interval_;
    better_ = pays ? Way::culled : Way::plain;
  }

  double plain_ = -1, culled_ = -1;   // seconds; negative: not measured
  int triesLeft_ = 0, vainLeft_ = 0;  // culled draws, and failed ones, until the trial ends
  int hold_ = 0, interval_ = kHold;
  Way better_ = Way::plain;
};

}  // namespace gluray::gl
