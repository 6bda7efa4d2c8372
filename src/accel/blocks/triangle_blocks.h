// Triangle blocks: runs of neighbouring triangles, which are the leaves of an acceleration structure in place
// of single triangles. Such a structure takes less memory and is built sooner. Made by Blas; read by any
// number of tracing threads.
#pragma once
#include "accel/impostors/impostors.h"
#include "scene/mesh.h"

#include <cstdint>
#include <vector>

struct RTCBoundsFunctionArguments;
struct RTCIntersectFunctionNArguments;
struct RTCOccludedFunctionNArguments;

namespace gluray::accel {

/// Triangles [first(c), first(c + 1)) of a mesh are block c. Triangles that follow each other in the mesh
/// are together as long as a box about them is not much larger than their own boxes in sum: where programs
/// send triangles in an order that keeps neighbours near each other, nearly all blocks are full.
class TriangleBlocks {
 public:
  enum class Aim : uint8_t {
    memory,  // few, large blocks: least memory
    speed    // small blocks, which rays test as fast as single triangles; their boxes are kept for the build
  };

  /// Looks at all triangles, with the threads of the current arena. Throws std::bad_alloc.
  TriangleBlocks(const scene::Mesh&, Aim);

  uint32_t count() const { return static_cast<uint32_t>(first_.size() - 1); }
  uint32_t first(uint32_t block) const { return first_[block]; }
  const scene::Mesh& mesh() const { return mesh_; }
  size_t bytes() const { return first_.capacity() * sizeof(uint32_t); }
  /// Whether those of a mesh are likely to pay(): looks at a few thousand of its triangles. False for meshes
  /// that have not many. The arrays must be such as checkArrays() accepts (blas.h).
  static bool likely(const scene::Mesh&, Aim);
  /// Whether there are so few that they need much less than the triangles would: memory, or time.
  bool pay() const;
  /// A box about a block, wide enough that no rounding of Embree's keeps rays from it. Without extent, and
  /// with lower > upper, where it holds one triangle that has a vertex that is not finite.
  Box boxOf(uint32_t block) const;
  /// They are computed again from now on.
  void forgetBoxes() { std::vector<Box>().swap(boxes_); }

 private:
  Aim aim_;
  scene::Mesh mesh_;  // the arrays that triangles are read from
  std::vector<uint32_t> first_;
  std::vector<Box> boxes_;  // of all blocks, or none
};

/// Embree's callbacks; their user data is the TriangleBlocks. Hits are those that Embree's own watertight
/// test of triangles gives, to the bit, and bear the number of the triangle.
void triangleBlockBounds(const RTCBoundsFunctionArguments*);
void intersectTriangleBlocks(const RTCIntersectFunctionNArguments*);
void occludeTriangleBlocks(const RTCOccludedFunctionNArguments*);

}  // namespace gluray::accel
