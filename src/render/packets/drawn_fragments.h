// Fragments of a packet's pixels for blending in drawing order. Used by the kernels on tracing threads.
#pragma once
#include "accel/rays/ray_packet.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace gluray::render {

struct DrawnFragment {
  uint64_t order;  // drawing order: of its instance, then of its triangle
  float depth;
  uint32_t color;  // RGBA8
  bool operator<(const DrawnFragment& o) const { return order < o.order; }
};

/// The fragments of each pixel. Reuses its memory.
class DrawnFragments {
 public:
  void clear() {
    for (std::vector<DrawnFragment>& all : of_) all.clear();
  }
  void add(int lane, const DrawnFragment& fragment) { of_[lane].push_back(fragment); }
  void sort() {
    for (std::vector<DrawnFragment>& all : of_) std::sort(all.begin(), all.end());
  }
  /// Sorts by depth, farthest first; fragments with equal stored(depth) in drawing order.
  template <class Stored>
  void sortBackToFront(Stored&& stored) {
    for (std::vector<DrawnFragment>& all : of_) {
      for (DrawnFragment& fragment : all) fragment.depth = stored(fragment.depth);
      std::sort(all.begin(), all.end(), [](const DrawnFragment& a, const DrawnFragment& b) {
        return a.depth != b.depth ? a.depth > b.depth : a.order < b.order;
      });
    }
  }
  /// Copies the n-th fragment of each lane that has one; returns those lanes.
  uint32_t nth(size_t n, float* depth, uint32_t* color) const {
    uint32_t lanes = 0;
    for (int i = 0; i < accel::kLanes; ++i) {
      if (of_[i].size() <= n) continue;
      lanes |= 1u << i;
      depth[i] = of_[i][n].depth, color[i] = of_[i][n].color;
    }
    return lanes;
  }

 private:
  std::vector<DrawnFragment> of_[accel::kLanes];
};

}  // namespace gluray::render
