// Bounds of instances whose positions were captured by transform feedback, in clip space: clusters of each
// unit of instances. Finds the units that may be visible in front of a depth image. Loops run in the shared
// arena. A part of CulledMesh, GL thread.
#pragma once
#include "gl/culled/clusters/clusters.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gluray::gl {

class UnitClusters {
 public:
  /// Computes the boxes of `clusters` and `primitives` for each of `count` units, whose positions are `step`
  /// bytes apart. Throws std::bad_alloc.
  void find(const Clusters& clusters, const Primitives& primitives, size_t step, uint32_t count);
  const Clusters& clusters(uint32_t unit) const { return units_[unit]; }
  /// Sets bit i of `visible` if unit i may be visible; conservative (BoxVisibility).
  void mayShow(const WindowMapping& window, const DepthPyramid* pyramid,
               std::vector<uint64_t>& visible) const;

 private:
  std::vector<Clusters> units_;
};

}  // namespace gluray::gl
