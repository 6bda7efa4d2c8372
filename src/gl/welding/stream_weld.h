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

/// Deduplicates by a small hash table of recently kept vertices. It finds vertices that recur within some ten
/// thousand others, as in meshes whose order keeps neighbours together. Vertices that recur later may be kept
/// twice.
class StreamWelder {
 public:
  /// Compares `count` `arrived` vertices of `stride` floats with the first `kept` of `vertices`. Moves new
  /// vertices behind the kept ones (`arrived` may start there; there must be room). Appends the index of each
  /// arrived vertex to `indices`. Returns the new count of kept vertices. The stride must stay the same until
  /// forget(). Throws std::bad_alloc, with nothing changed.
  uint32_t weld(float* vertices, uint32_t stride, uint32_t kept, const float* arrived, uint32_t count,
                GrowingArray<uint32_t>& indices);
  void forget() { table_.release(); }

 private:
  GrowingArray<WeldEntry> table_;  // sets of two entries, the most recently used first
};

}  // namespace gluray::gl
