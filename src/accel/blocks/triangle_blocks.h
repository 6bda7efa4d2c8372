// Triangle blocks: several neighbouring triangles as one BVH leaf, in place of single triangles. The BVH
// takes less memory and builds faster. Made by Blas; read by any number of tracing threads.
#pragma once
#include "accel/impostors/placed_impostors.h"
#include "scene/mesh.h"

#include <cstdint>
#include <vector>

struct RTCBoundsFunctionArguments;
struct RTCIntersectFunctionNArguments;
struct RTCOccludedFunctionNArguments;

namespace gluray::accel {

/// Block c holds the consecutive triangles [first(c), first(c + 1)) of a mesh. A block grows while its
/// bounding box is not much larger than the sum of its triangles' boxes. Where programs send neighbouring
/// triangles one after the other, nearly all blocks are full.
class TriangleBlocks {
 public:
  enum class Aim : uint8_t {
    memory,  // few, large blocks: least memory
    speed    // small blocks: rays cost as much as with single triangles; boxes stay in memory for the build
  };

  /// Reads all triangles, with the threads of the current arena. Throws std::bad_alloc.
  TriangleBlocks(const scene::Mesh&, Aim);

  uint32_t count() const { return static_cast<uint32_t>(first_.size() - 1); }
  uint32_t first(uint32_t block) const { return first_[block]; }
  const scene::Mesh& mesh() const { return mesh_; }
  size_t bytes() const { return first_.capacity() * sizeof(uint32_t); }
  /// Predicts pay() from a sample of 4096 triangles. False for smaller meshes and for impostors.
  /// checkArrays() (blas.h) must accept the mesh.
  static bool likely(const scene::Mesh&, Aim);
  /// Whether there are few enough blocks that they need much less memory, or time, than single triangles.
  bool pay() const;
  /// A block's bounding box, widened so that rounding in Embree makes no ray miss it. Empty (lower > upper)
  /// for the block of a triangle with a vertex that is not finite.
  Box boxOf(uint32_t block) const;
  /// Frees the stored boxes; boxOf() then computes them on demand.
  void forgetBoxes() { std::vector<Box>().swap(boxes_); }

 private:
  Aim aim_;
  scene::Mesh mesh_;  // only the arrays that triangles are read from
  std::vector<uint32_t> first_;
  std::vector<Box> boxes_;  // one per block, or empty
};

/// Embree's callbacks; their user data is the TriangleBlocks. Hits equal those of Embree's own watertight
/// triangle test to the bit; their primitive is the triangle's number.
void triangleBlockBounds(const RTCBoundsFunctionArguments*);
void intersectTriangleBlocks(const RTCIntersectFunctionNArguments*);
void occludeTriangleBlocks(const RTCOccludedFunctionNArguments*);

}  // namespace gluray::accel
