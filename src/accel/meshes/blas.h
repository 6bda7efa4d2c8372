// The acceleration structure of one mesh. Made by BlasCache; read by any number of tracing threads.
#pragma once
#include "accel/blocks/triangle_blocks.h"
#include "accel/device.h"
#include "accel/impostors/impostors.h"
#include "accel/meshes/deformation.h"
#include "accel/meshes/iota_indices.h"
#include "scene/mesh.h"
#include "settings/settings.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

struct RTCGeometryTy;
struct RTCSceneTy;

namespace gluray::accel {

/// What a structure is made of. `reach` matters to meshes of impostors alone.
struct Geometry {
  const scene::Mesh* mesh = nullptr;
  ImpostorReach reach;
  /// Equal where the structure would be.
  Hash128 id() const;
};

/// Throws Error where the arrays of a mesh cannot be read in place.
void checkArrays(const scene::Mesh&);

class Blas;
using BlasPtr = std::shared_ptr<Blas>;

/// A bottom-level structure over the positions and triangles of a mesh, which are read in place and kept
/// alive. (primitive, u, v) of its hits hold for every geometry of equal id.
class Blas {
 public:
  /// Prepares the structure; build() makes it. Throws Error where the arrays cannot be read.
  Blas(const Device&, IotaIndices&, const Geometry&, BvhQuality);
  /// The same of triangles that can be adjusted to other positions later: of middling quality.
  static BlasPtr createToRefit(const Device&, IotaIndices&, const Geometry&);
  /// `from`, made to be adjusted and of no use from now on, to be built for the positions of a mesh that has
  /// its topology.
  static BlasPtr createRefitted(Blas& from, const scene::Mesh&);
  ~Blas();
  Blas(const Blas&) = delete;
  Blas& operator=(const Blas&) = delete;

  /// Builds with the threads of the arena it is called in. Throws Error; the structure is then useless.
  /// Triangles with a vertex that is not finite are left out.
  void build();
  /// The same at leisure, on the calling thread alone, in an arena of one thread. Ends early, and throws,
  /// soon after `cancelled` has become true.
  void buildBehind(const std::atomic<bool>& cancelled);

  RTCSceneTy* scene() const { return scene_; }
  /// Bytes of the structure, and of the mesh arrays that it keeps alive.
  size_t bvhBytes() const { return bvhBytes_; }
  size_t pinnedBytes() const { return pinnedBytes_; }
  uint32_t triangleCount() const { return triangleCount_; }
  /// Whether it holds triangles of the same vertices as the mesh. Compares all indices.
  bool hasTopologyOf(const scene::Mesh&) const;
  /// How far its triangles have moved apart in the mesh, which has its topology; 0: it cannot be adjusted to
  /// that.
  double spreadIn(const scene::Mesh&) const;

 private:
  void commit();
  Blas(Blas& from, const scene::Mesh&);
  Blas(const Device&, IotaIndices&, const Geometry&, BvhQuality, bool toRefit);
  void setPositions(RTCGeometryTy*, const scene::Mesh&);
  RTCGeometryTy* triangles(IotaIndices&, const scene::Mesh&);
  RTCGeometryTy* impostors(const Geometry&);
  /// Null where blocks do not pay.
  RTCGeometryTy* blocks(const scene::Mesh&, TriangleBlocks::Aim);

  const Device& device_;
  RTCSceneTy* scene_ = nullptr;
  std::shared_ptr<const void> positions_, indices_;
  scene::Mesh impostors_;  // where they are none: the arrays that bounds are read from
  ImpostorReach reach_;
  std::pair<const scene::Mesh*, const ImpostorReach*> bounded_;  // both, for Embree's callback
  std::unique_ptr<TriangleBlocks> blocks_;  // where they are what the structure is made of
  size_t bvhBytes_ = 0, pinnedBytes_ = 0;
  uint32_t triangleCount_ = 0, vertexCount_ = 0;
  const void* indexData_ = nullptr;  // of triangles; null: they are a soup
  bool impostorsOnly_ = false;
  std::unique_ptr<Neighbours> neighbours_;  // where it can be adjusted
};

}  // namespace gluray::accel
