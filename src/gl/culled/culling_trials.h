// Whether culling a draw pays: measured, as EngineChoice measures frames. Calls no OpenGL. GL thread.
#pragma once
#include <algorithm>
#include <cstdint>

namespace gluray::gl {

class CullingTrials {
 public:
  enum class Way : uint8_t { plain, culled };
  struct Next {
    Way way = Way::plain;
    bool measured = false;  // finish all before and after, and tell took()
  };

  /// How to make the next draw. `always`: culled, and nothing is measured. A culled draw that cannot be made
  /// counts as a plain one.
  Next next(bool always) {
    if (always) return {Way::culled, false};
    if (plain_ < 0) return {Way::plain, true};
    if (culledLeft_ > 0) return {Way::culled, true};
    if (--hold_ > 0) return {better_, false};
    // Tried again: culled draws more and more rarely where they do not pay; plain ones where they are slower.
    if (better_ == Way::culled) return {Way::plain, true};
    culledLeft_ = kTries, culled_ = -1;
    return {Way::culled, true};
  }

  void took(Way way, double seconds) {
    if (way == Way::plain) {
      plain_ = seconds;
      culledLeft_ = std::max(culledLeft_, kTries), culled_ = -1;
      return;
    }
    culled_ = culled_ < 0 ? seconds : std::min(culled_, seconds);
    if (--culledLeft_ > 0) return;
    const bool pays = culled_ < kGain * plain_;
    interval_ = pays ? kHold : std::min(2 * interval_, kLongHold);
    hold_ = pays ? kLongHold : interval_;
    better_ = pays ? Way::culled : Way::plain;
  }
  bool pays() const { return better_ == Way::culled || culledLeft_ > 0; }  // or is being tried

 private:
  static constexpr int kTries = 3;      // culled draws that are measured; the first ones have a poor guess
  static constexpr double kGain = 0.9;  // of the plain time, which culled draws must stay below
  static constexpr int kHold = 32, kLongHold = 1024;  // draws until the next trial

  double plain_ = -1, culled_ = -1;  // seconds; negative: not measured
  int culledLeft_ = 0, hold_ = 0, interval_ = kHold;
  Way better_ = Way::plain;
};

}  // namespace gluray::gl
