// Finds equal vertices while they are captured, so that a large triangle soup never exists whole. One
// thread at a time.
#pragma once
#include "gl/capture/growing_array.h"

#include <cstdint>

namespace gluray::gl {

/// A vertex that was kept, and bits of its hash.
struct WeldEntry {
  uint32_t vertex, tag;
};

/// Remembers the vertices kept lately. Those that come again within some ten thousand others are always
/// found where meshes are sent in any order that keeps neighbours near each other.
class StreamWelder {
 public:
  /// `count` vertices of `stride` floats have `arrived`: behind the `kept` of `vertices`, or elsewhere; there
  /// is room for them behind those kept. Moves the new ones among them there, appends for each the number
  /// that it has now to `indices`, and returns how many are kept. The stride must stay the same until
  /// forget(). Throws std::bad_alloc, with nothing changed.
  uint32_t weld(float* vertices, uint32_t stride, uint32_t kept, const float* arrived, uint32_t count,
                GrowingArray<uint32_t>& indices);
  void forget() { table_.release(); }

 private:
  GrowingArray<WeldEntry> table_;  // in pairs, the one used last first
};

}  // namespace gluray::gl
