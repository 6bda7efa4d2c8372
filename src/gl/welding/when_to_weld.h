// Vertex count from which VertexStream welds a run while it is being sent. Owned by Immediate, GL thread.
#pragma once
#include <cstdint>

namespace gluray::gl {

/// Chooses the vertex count from which a run is welded (equal vertices share one index).
/// A display list is drawn many times: its runs are welded from kWorthWelding vertices. A run outside lists
/// is sent again every frame, and finding its mesh by content hash is cheaper than welding: it is welded only
/// from kTooLarge vertices, where it would not fit into memory otherwise. After such a run, those outside
/// lists are welded from kWorthWelding vertices, until one of at least that many stays below kTooLarge.
class WhenToWeld {
 public:
  static constexpr uint32_t kWorthWelding = 1u << 16, kTooLarge = 56'000'000;  // vertices

  uint32_t inList() const { return kWorthWelding; }
  uint32_t inFrame() const { return large_ ? kWorthWelding : kTooLarge; }
  /// Call with the vertex count of each finished run outside lists.
  void sawRun(uint64_t vertices) {
    if (vertices >= kWorthWelding) large_ = vertices >= kTooLarge;
  }

 private:
  bool large_ = false;  // the last run of at least kWorthWelding vertices reached kTooLarge
};

}  // namespace gluray::gl
