// Runs of neighbouring triangles as leaves of an acceleration structure: for meshes whose structures would
// not fit into memory otherwise. Made by Blas; read by any number of tracing threads.
#pragma once
#include "accel/impostors/impostors.h"
#include "scene/mesh.h"

#include <cstdint>
#include <vector>

struct RTCBoundsFunctionArguments;
struct RTCIntersectFunctionNArguments;

namespace gluray::accel {

/// Triangles [first(c), first(c + 1)) of a mesh are cluster c. Triangles that follow each other in the mesh
/// are together as long as a box about them is not much larger than their own boxes in sum: where programs
/// send triangles in an order that keeps neighbours near each other, nearly all clusters are full.
class Clusters {
 public:
  enum class Aim : uint8_t {
    memory,  // as few as rays can bear
    speed  // built soon and met as soon as single triangles are; boxes are kept as builds ask for each often
  };

  /// Looks at all triangles, with the threads of the current arena. Throws std::bad_alloc.
  Clusters(const scene::Mesh&, Aim);

  uint32_t count() const { return static_cast<uint32_t>(first_.size() - 1); }
  uint32_t first(uint32_t cluster) const { return first_[cluster]; }
  const scene::Mesh& mesh() const { return mesh_; }
  size_t bytes() const { return first_.capacity() * sizeof(uint32_t); }
  /// Whether those of a mesh are likely to pay(): looks at a few thousand of its triangles. False for meshes
  /// that have not many. The arrays must be such as checkArrays() accepts (blas.h).
  static bool likely(const scene::Mesh&, Aim);
  /// Whether there are so few that they need much less than the triangles would: memory, or time.
  bool pay() const;
  /// A box about a cluster, wide enough that no rounding of Embree's keeps rays from it. Without extent, and
  /// with lower > upper, where it holds one triangle that has a vertex that is not finite.
  Box boxOf(uint32_t cluster) const;
  /// They are computed again from now on.
  void forgetBoxes() { std::vector<Box>().swap(boxes_); }

 private:
  Aim aim_;
  scene::Mesh mesh_;  // the arrays that triangles are read from
  std::vector<uint32_t> first_;
  std::vector<Box> boxes_;  // of all clusters, or none
};

/// Embree's callbacks; their user data is the Clusters. Hits are those that Embree's own watertight test of
/// triangles gives, to the bit, and bear the number of the triangle.
void clusterBounds(const RTCBoundsFunctionArguments*);
void intersectClusters(const RTCIntersectFunctionNArguments*);

}  // namespace gluray::accel
