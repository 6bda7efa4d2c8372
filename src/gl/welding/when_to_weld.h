// Decides from which vertex on a run is welded while it arrives. Owned by Immediate, GL thread.
#pragma once
#include <cstdint>

namespace gluray::gl {

/// When a run starts to be welded, that is, when vertices that are equal begin to share one number.
/// Runs of display lists are drawn many times: they are welded from kWorthWelding vertices on. Runs outside
/// lists arrive anew in every frame, and comparing them with the last frame's is cheaper than welding; they
/// are welded only from kTooLarge vertices on, where unwelded ones would not fit into memory. The frames
/// after such a run weld from kWorthWelding vertices on.
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
