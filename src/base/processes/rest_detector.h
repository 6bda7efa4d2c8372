// Tells when a program that draws is at rest: no frame has ended for a while, and it computes little. Used by
// one thread at a time.
#pragma once
#include <cstdint>

namespace gluray {

class RestDetector {
 public:
  /// `quiet`: seconds without another frame.
  explicit RestDetector(double quiet) : quiet_(quiet) {}

  /// Call from time to time. `frames`: that have ended; `now`: seconds; worked(): processor seconds that the
  /// program has used, asked for only when they count.
  template <class Worked>
  bool isAtRest(uint64_t frames, double now, const Worked& worked) {
    constexpr double kIdle = 0.2;  // of one core
    const bool quiet = frames > 0 && frames == frames_;
    if (quiet && now - since_ < quiet_) return false;
    const double seconds = worked();
    if (quiet && seconds - worked_ < kIdle * (now - since_)) return true;
    frames_ = frames, since_ = now, worked_ = seconds;
    return false;
  }

 private:
  double quiet_;
  uint64_t frames_ = 0;
  double since_ = 0, worked_ = 0;
};

}  // namespace gluray
