// Detects whether a program draws frames continuously, so that a frame that is shown late is soon followed by
// the next one. GL thread.
#pragma once
#include <algorithm>

namespace gluray::intercept {

class FollowingFrames {
 public:
  static constexpr double kMaxGap = 0.1;  // seconds from a swap to the first sign of the next frame
  static constexpr int kFrames = 3;       // consecutive frames that must have come this soon

  /// Call when a frame is complete. `began`: time of its first sign, in seconds on any clock. Returns whether
  /// frames are continuous.
  bool complete(double began) {
    follow_ = shown_ > 0 && began - shown_ < kMaxGap ? std::min(follow_ + 1, kFrames) : 0;
    return follow_ == kFrames;
  }
  /// Call when the swap has returned.
  void swapped(double now) { shown_ = now; }

 private:
  double shown_ = 0;
  int follow_ = 0;
};

}  // namespace gluray::intercept
