// Bounds of instances whose positions were captured by transform feedback, in clip space: clusters of each
// unit of instances. Finds the units that may be visible in front of a depth picture. Loops run in the shared
// arena. A part of CulledMesh, GL thread.
#pragma once
#include "gl/culled/clusters/clusters.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gluray::gl {

class UnitClusters {
 public:
  /// Moves clusters that are like those of `clusters`, of `primitives`, for each of `count` units, whose
  /// positions are `step` bytes after those of the unit before. Throws std::bad_alloc.
  void find(const Clusters& clusters, const Primitives& primitives, size_t step, uint32_t count);
  const Clusters& clusters(uint32_t unit) const { return units_[unit]; }
  /// Sets bit i of `visible` where unit i may show: never misses one (BoxVisibility).
  void mayShow(const WindowMapping& window, const DepthPyramid* pyramid,
               std::vector<uint64_t>& visible) const;

 private:
  std::vector<Clusters> units_;
};

}  // namespace gluray::gl
