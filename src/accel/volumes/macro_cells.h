// Blocks of a volume's voxels with the range of their values: what lets rays leap over empty space. Any
// thread.
#pragma once
#include "scene/volumes/voxel_grid.h"

#include <glm/glm.hpp>

#include <vector>

namespace gluray::accel {

/// Cells of kSide^3 intervals between voxels. Cell (i, j, k) bounds all that a linear filter returns between
/// voxels kSide * i and kSide * (i + 1), and likewise along y and z.
class MacroCells {
 public:
  static constexpr int kSide = 8;
  /// Least and most of a channel's texture values.
  struct Range {
    float least, most;
  };

  /// Of channel `channel`. Uses the threads of sharedArena(). Throws std::bad_alloc.
  MacroCells(const scene::VoxelGrid& grid, int channel);
  const glm::ivec3& size() const { return size_; }
  const std::vector<Range>& ranges() const { return ranges_; }
  /// Whether all values are finite.
  bool finite() const { return finite_; }
  size_t bytes() const { return ranges_.capacity() * sizeof(Range); }

 private:
  glm::ivec3 size_;
  std::vector<Range> ranges_;  // x fastest
  bool finite_ = true;
};

}  // namespace gluray::accel
