// Whether a program's frames follow each other, so that one that is shown late is soon followed by the next.
// GL thread.
#pragma once
#include <algorithm>

namespace gluray::intercept {

class FollowingFrames {
 public:
  static constexpr double kMostGap = 0.1;  // seconds from a swap to the first sign of the next frame
  static constexpr int kFrames = 3;        // that must have come so soon

  /// A frame that was first seen at `began` is complete; seconds of any clock. Whether it and those before
  /// followed.
  bool complete(double began) {
    follow_ = shown_ > 0 && began - shown_ < kMostGap ? std::min(follow_ + 1, kFrames) : 0;
    return follow_ == kFrames;
  }
  /// The swap has returned.
  void swapped(double now) { shown_ = now; }

 private:
  double shown_ = 0;
  int follow_ = 0;
};

}  // namespace gluray::intercept
