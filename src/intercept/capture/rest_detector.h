// Tells when a program that shows windows is at rest: no frame has ended for a while, and the process
// computes little. Used by one thread at a time.
#pragma once
#include <cstdint>

namespace gluray::intercept {

class RestDetector {
 public:
  /// Call from time to time. `frames`: that have ended; `now`: seconds; `worked`: processor seconds of the
  /// process.
  bool isAtRest(uint64_t frames, double now, double worked);
  bool isAtRest(uint64_t frames, double now) { return isAtRest(frames, now, processorSeconds()); }

 private:
  static double processorSeconds();

  uint64_t frames_ = 0;
  double since_ = 0, worked_ = 0;
};

}  // namespace gluray::intercept
