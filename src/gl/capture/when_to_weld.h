// From which vertex on a run's equal vertices are found while they arrive. Owned by Immediate, GL thread.
#pragma once
#include <cstdint>

namespace gluray::gl {

/// Lists are drawn again and again: welding pays. What comes in every frame is captured and compared sooner
/// than welded, but memory is for runs of a gigabyte or so: what exceeds that is welded, and its like in
/// later frames from the beginning, while it arrives.
class WhenToWeld {
 public:
  static constexpr uint32_t kWorthWelding = 1u << 16, kTooLarge = 56'000'000;  // vertices

  uint32_t inList() const { return kWorthWelding; }
  uint32_t inFrame() const { return large_ ? kWorthWelding : kTooLarge; }
  /// A run outside lists came to so many vertices.
  void sawRun(uint64_t vertices) {
    if (vertices >= kWorthWelding) large_ = vertices >= kTooLarge;
  }

 private:
  bool large_ = false;  // the last one that was worth welding
};

}  // namespace gluray::gl
