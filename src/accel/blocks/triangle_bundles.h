// Triangle bundles of a mesh: up to eight neighbouring triangle blocks as one primitive of the BVH, which
// then has about a fifth of the primitives and needs half the memory (docs/adr/0082). Made by Blas; read by
// any number of tracing threads.
#pragma once
#include "accel/blocks/triangle_bundle_kernels.h"
#include "accel/impostors/placed_impostors.h"
#include "scene/mesh.h"

#include <cstdint>
#include <memory>
#include <vector>

struct RTCBoundsFunctionArguments;
struct RTCIntersectFunctionNArguments;
struct RTCOccludedFunctionNArguments;

namespace gluray::accel {

/// The blocks of some ten thousand triangles in a row are sorted along a Morton curve and cut into bundles. A
/// bundle grows while its bounding box is not much larger than the sum of its blocks' boxes. Triangles with a
/// vertex that is not finite are left out.
class TriangleBundles {
 public:
  /// Reads all triangles, with the threads of the current arena. Throws std::bad_alloc.
  explicit TriangleBundles(const scene::Mesh&);

  uint32_t count() const { return static_cast<uint32_t>(bundles_.size()); }
  const TriangleBundle& operator[](uint32_t i) const { return *bundles_[i]; }
  const scene::Mesh& mesh() const { return mesh_; }
  /// The arrays of the mesh.
  TriangleRun arrays() const;
  size_t bytes() const { return bundles_.size() * (sizeof(TriangleBundle) + sizeof(TriangleBundle*)); }
  static constexpr uint32_t kSampled = 1 << 14;  // triangles
  /// Predicts pay() from a sample of kSampled triangles. False for smaller meshes and for impostors.
  /// checkArrays() (blas.h) must accept the mesh.
  static bool likely(const scene::Mesh&);
  /// Whether the bundles are full enough to need less memory and time than triangle blocks.
  bool pay() const;
  /// The bounding box of all blocks.
  Box boxOf(uint32_t bundle) const;

 private:
  scene::Mesh mesh_;  // only the arrays that triangles are read from
  std::vector<std::unique_ptr<TriangleBundle[]>> parts_;
  std::vector<const TriangleBundle*> bundles_;
};

/// Embree's callbacks; their user data is the TriangleBundles. Hits are those of triangle blocks.
void triangleBundleBounds(const RTCBoundsFunctionArguments*);
void intersectTriangleBundles(const RTCIntersectFunctionNArguments*);
void occludeTriangleBundles(const RTCOccludedFunctionNArguments*);

}  // namespace gluray::accel
