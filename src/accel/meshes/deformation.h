// Decides when to refit a BLAS instead of rebuilding it, for meshes whose vertices move while their indices
// stay the same. Used by BlasCache; any thread, one at a time.
#pragma once
#include "scene/mesh.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace gluray::accel {

/// Whether every coordinate is finite and within Embree's range. Embree leaves out triangles with any other
/// coordinate, also from later refits. Reads all positions.
bool allInReach(const scene::Mesh& mesh);

/// A sample of triangles, grouped by position when the BLAS was built: stands for the BLAS's nodes.
class Neighbours {
 public:
  Neighbours() = default;
  /// Picks a few thousand of the triangles.
  explicit Neighbours(const scene::Mesh& mesh);
  /// Surface area of the groups' boxes relative to that of the whole mesh, divided by its value at the build:
  /// 1 means no growth. The number of nodes that a ray visits grows by about this factor.
  double spreadIn(const scene::Mesh& mesh) const;

 private:
  double areaShare(const scene::Mesh& mesh) const;
  std::vector<uint32_t> triangles_;  // kGroup triangles per group, group after group
  double share_ = 0;
};

/// Decides from the history of such meshes. Meshes with equal numbers of vertices and triangles share one
/// history.
class Deformations {
 public:
  enum class Step : uint8_t {
    build,         // ordinary build
    buildToRefit,  // build a refittable structure: takes about four times as long as a fast build
    refit,         // refit the earlier structure: a sixth of that
  };
  /// Smallest mesh, in triangles, that is refitted: smaller ones build in negligible time.
  static constexpr uint32_t kMin = 10'000;
  /// The step for a mesh whose positions changed. `spread`: Blas::spreadIn of the earlier structure; 0: it
  /// cannot be refitted.
  Step stepFor(const scene::Mesh& mesh, double spread);
  /// Reports that positions have returned whose structure was refitted to other positions, because the
  /// animation repeats. Pauses refits.
  void comesAround(const scene::Mesh& mesh);

 private:
  struct Course {
    int steps = 0;   // consecutive changes of positions
    int refits = 0;  // since the structure was built
    int pause = 0;   // remaining steps without refits
  };
  std::map<std::pair<uint32_t, uint32_t>, Course> courses_;
};

}  // namespace gluray::accel
