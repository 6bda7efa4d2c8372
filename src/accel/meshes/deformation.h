// Decides when to refit an acceleration structure: for meshes whose vertices move while their triangles stay
// the same. Any thread, one at a time.
#pragma once
#include "scene/mesh.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace gluray::accel {

/// Whether every coordinate is finite and within Embree's reach. Others make triangles that a structure
/// leaves out, whichever positions they are adjusted to later. Reads all of them.
bool allInReach(const scene::Mesh& mesh);

/// Groups of triangles that lay together when the structure was built, as those of its nodes do.
class Neighbours {
 public:
  Neighbours() = default;
  /// Picks a few thousand of the triangles.
  explicit Neighbours(const scene::Mesh& mesh);
  /// How large the groups have become beside the whole, areas of boxes: 1 as when they were picked. Rays meet
  /// about as many more nodes.
  double spreadIn(const scene::Mesh& mesh) const;

 private:
  double areaShare(const scene::Mesh& mesh) const;
  std::vector<uint32_t> triangles_;  // kGroup after another
  double share_ = 0;
};

/// Decides by what such meshes have cost so far. Meshes of equal numbers of vertices and triangles count as
/// one.
class Deformations {
 public:
  enum class Step : uint8_t {
    build,         // as if nothing were known of earlier positions
    buildToRefit,  // so that the structure can be adjusted: takes some four times as long as a fast build
    refit,         // the earlier structure, a sixth of that
  };
  /// Least triangles: smaller meshes are built in no time.
  static constexpr uint32_t kLeast = 10'000;
  /// A mesh with other positions than before. `spread`: that of the earlier structure, where it can be
  /// adjusted; 0: it cannot.
  Step next(const scene::Mesh& mesh, double spread);
  /// Positions that a structure was adjusted from are there again: they come round, and are better kept.
  void comesAround(const scene::Mesh& mesh);

 private:
  struct Course {
    int steps = 0;   // in a row
    int refits = 0;  // since the structure was built
    int pause = 0;   // steps that are built
  };
  std::map<std::pair<uint32_t, uint32_t>, Course> courses_;
};

}  // namespace gluray::accel
