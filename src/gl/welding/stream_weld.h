// Deduplicates ("welds") vertices while they are captured, so that a large triangle soup is never stored in
// full. Called by VertexStream, and by WeldBehind on its thread; one thread at a time.
#pragma once
#include "gl/basics/growing_array.h"

#include <cstdint>

namespace gluray::gl {

/// Hash table entry: the number of a kept vertex, and 32 bits of its hash.
struct WeldEntry {
  uint32_t vertex, tag;
};

/// Remembers recently kept vertices in a small hash table. Finds vertices that recur within some ten thousand
/// others, as in meshes sent in any order that keeps neighbours together; later ones may be kept twice.
class StreamWelder {
 public:
  /// Compares `count` `arrived` vertices of `stride` floats with the first `kept` of `vertices`. Moves the
  /// new ones behind those (`arrived` may start there; there must be room), and appends the number of each
  /// to `indices`. Returns the new count of kept vertices. The stride must stay the same until forget().
  /// Throws std::bad_alloc, with nothing changed.
  uint32_t weld(float* vertices, uint32_t stride, uint32_t kept, const float* arrived, uint32_t count,
                GrowingArray<uint32_t>& indices);
  void forget() { table_.release(); }

 private:
  GrowingArray<WeldEntry> table_;  // sets of two entries, the most recently used first
};

}  // namespace gluray::gl
