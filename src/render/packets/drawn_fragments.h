// Fragments of a packet's pixels for blending in drawing order. Used by the kernels on tracing threads.
#pragma once
#include "accel/rays/ray_packet.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace gluray::render {

struct DrawnFragment {
  uint64_t order;  // drawing order: of its instance, then of its triangle
  float depth;
  uint32_t color;  // RGBA8, or the number of a colour of floats
  bool operator<(const DrawnFragment& o) const { return order < o.order; }
};

/// The fragments of each pixel. Reuses its memory.
class DrawnFragments {
 public:
  void clear() {
    for (std::vector<DrawnFragment>& all : of_) all.clear();
    floats_.clear();
  }
  void add(int lane, const DrawnFragment& fragment) { of_[lane].push_back(fragment); }
  /// Adds a fragment whose colour is floats; fragment.color does not count.
  void add(int lane, DrawnFragment fragment, const std::array<float, 4>& color) {
    fragment.color = static_cast<uint32_t>(floats_.size());
    floats_.push_back(color);
    of_[lane].push_back(fragment);
  }
  /// The colour with that number, which nth() gave.
  const std::array<float, 4>& floats(uint32_t color) const { return floats_[color]; }
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
  std::vector<std::array<float, 4>> floats_;
};

}  // namespace gluray::render
