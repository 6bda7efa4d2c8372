// Depth-sorted layers of a packet's pixels, for compositing after a limited number of peels
// (scene::Layers::peels). Used by the kernels on tracing threads.
#pragma once
#include "accel/rays/ray_packet.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace gluray::render {

struct PeeledLayer {
  uint64_t order;              // drawing order: of its instance, then of its triangle
  std::array<float, 4> color;  // premultiplied RGB, and opacity
  bool operator<(const PeeledLayer& o) const { return order < o.order; }
};

/// The layers of each pixel. Reuses its memory.
class PeeledLayers {
 public:
  void clear() {
    for (std::vector<PeeledLayer>& all : of_) all.clear();
  }
  /// Appends a layer behind those of a lane.
  void add(int lane, const PeeledLayer& layer) { of_[lane].push_back(layer); }
  /// Merges a fragment at equal depth into the lane's last layer: every channel keeps the larger value.
  void join(int lane, const PeeledLayer& layer) {
    std::array<float, 4>& color = of_[lane].back().color;
    for (size_t c = 0; c < 4; ++c) color[c] = std::max(color[c], layer.color[c]);
  }
  size_t count(int lane) const { return of_[lane].size(); }

  /// The lane's colour from dual depth peeling: the first `nearest` and last `farthest` layers in depth
  /// order, and between them the others in the order of drawing. Reorders the lane's layers; requires at
  /// least nearest + farthest.
  std::array<float, 4> mixed(int lane, size_t nearest, size_t farthest) {
    std::vector<PeeledLayer>& all = of_[lane];
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(nearest),
               end = all.end() - static_cast<std::ptrdiff_t>(farthest);
    std::stable_sort(begin, end);
    std::array<float, 4> behind{};
    const auto putOver = [&](const PeeledLayer& layer) {
      for (size_t c = 0; c < 4; ++c) behind[c] = layer.color[c] + (1 - layer.color[3]) * behind[c];
    };
    for (auto layer = all.end(); layer != end;) putOver(*--layer);
    for (auto layer = begin; layer != end; ++layer) putOver(*layer);
    for (auto layer = begin; layer != all.begin();) putOver(*--layer);
    return behind;
  }

 private:
  std::vector<PeeledLayer> of_[accel::kLanes];
};

}  // namespace gluray::render
