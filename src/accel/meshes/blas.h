// The acceleration structure (BLAS) of one mesh. Made by BlasCache; read by any number of tracing threads.
#pragma once
#include "accel/blocks/triangle_blocks.h"
#include "accel/blocks/triangle_bundles.h"
#include "accel/device/device.h"
#include "accel/impostors/placed_impostors.h"
#include "accel/meshes/deformation.h"
#include "accel/meshes/iota_indices.h"
#include "scene/mesh.h"
#include "settings/settings.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

struct RTCBoundsFunctionArguments;
struct RTCGeometryTy;
struct RTCIntersectFunctionNArguments;
struct RTCOccludedFunctionNArguments;
struct RTCSceneTy;

namespace gluray::accel {

/// The input of a BLAS. `reach` matters only for impostors.
struct Geometry {
  const scene::Mesh* mesh = nullptr;
  ImpostorReach reach;
  const scene::MeshPtr* owner = nullptr;  // of `mesh`; null: not known
  std::weak_ptr<const scene::Mesh> weakOwner() const {
    return owner ? *owner : std::weak_ptr<const scene::Mesh>();
  }
  /// Equal ids mean equal structures.
  Hash128 id() const;
};

/// Throws Error if the arrays of a mesh cannot be read in place.
void checkArrays(const scene::Mesh&);

class Blas;
using BlasPtr = std::shared_ptr<Blas>;

/// Primitives that Embree accesses only through callbacks. `data`: passed to the callbacks as
/// geometryUserPtr; the structure keeps it alive.
struct UserPrimitives {
  uint32_t count = 0;
  std::shared_ptr<void> data;
  void (*bounds)(const RTCBoundsFunctionArguments*) = nullptr;
  void (*intersect)(const RTCIntersectFunctionNArguments*) = nullptr;
  void (*occlude)(const RTCOccludedFunctionNArguments*) = nullptr;
};

struct ReleaseScene {
  void operator()(RTCSceneTy*) const;
};

/// Reads positions and indices of the mesh in place and keeps them alive. (primitive, u, v) of its hits are
/// valid for every geometry of equal id.
class Blas {
 public:
  /// Prepares the structure; build() builds it. Throws Error if the arrays cannot be read.
  Blas(const Device&, IotaIndices&, const Geometry&, BvhQuality);
  /// A structure of triangles, of medium quality, that can be refitted to other positions later.
  static BlasPtr createToRefit(const Device&, IotaIndices&, const Geometry&);
  /// Refits `from`, made by createToRefit(), to the positions of a mesh of the same topology: build()
  /// finishes it. `from` is unusable afterwards.
  static BlasPtr createRefitted(Blas& from, const scene::Mesh&);
  /// A structure of primitives that replace the mesh, whose arrays are not read.
  Blas(const Device&, const scene::Mesh&, UserPrimitives);
  ~Blas();
  Blas(const Blas&) = delete;
  Blas& operator=(const Blas&) = delete;

  /// Builds with the threads of the current arena. Throws Error; the structure is then unusable. Omits
  /// triangles with a vertex that is not finite.
  void build();
  /// Like build(), in the background: only on the calling thread, in an arena of one thread. Stops and throws
  /// soon after `cancelled` becomes true.
  void buildBehind(const std::atomic<bool>& cancelled);
  /// Prepares and builds a structure only on the calling thread, without running other tasks of its arena
  /// meanwhile. Throws Error.
  static BlasPtr buildAlone(const Device&, IotaIndices&, const Geometry&, BvhQuality);

  RTCSceneTy* scene() const { return scene_.get(); }
  /// Bytes of the structure; bytes of the mesh arrays that it keeps alive.
  size_t bvhBytes() const { return bvhBytes_ + leafBytes_.bytes(); }
  size_t pinnedBytes() const { return pinnedBytes_; }
  uint32_t triangleCount() const { return triangleCount_; }
  /// Whether its triangles have the same indices as those of the mesh. Compares all indices.
  bool hasTopologyOf(const scene::Mesh&) const;
  /// Growth of its nodes if refitted to the mesh, which has its topology: see Neighbours::spreadIn. 0: it
  /// cannot be refitted.
  double spreadIn(const scene::Mesh&) const;

 private:
  void commit();
  Blas(Blas& from, const scene::Mesh&);
  Blas(const Device&, IotaIndices&, const Geometry&, BvhQuality, bool toRefit);
  void setPositions(RTCGeometryTy*, const scene::Mesh&);
  RTCGeometryTy* triangles(IotaIndices&, const scene::Mesh&);
  RTCGeometryTy* impostors(const Geometry&, BvhQuality);
  /// Null unless TriangleBlocks::pay().
  RTCGeometryTy* blocks(const scene::Mesh&, TriangleBlocks::Aim);
  /// Null unless TriangleBundles::pay().
  RTCGeometryTy* bundles(const scene::Mesh&);
  void pinIndices(const scene::Mesh&);

  const Device& device_;
  std::shared_ptr<const void> positions_, indices_;
  scene::Mesh impostors_;  // of impostors: the arrays that bounds are read from
  ImpostorReach reach_;
  std::pair<const scene::Mesh*, const ImpostorReach*> bounded_;  // both, for Embree's callback
  // The leaves; both null: single triangles or impostors.
  std::unique_ptr<TriangleBlocks> blocks_;
  std::unique_ptr<TriangleBundles> bundles_;
  HeldBytes leafBytes_;
  size_t bvhBytes_ = 0, pinnedBytes_ = 0;
  uint32_t triangleCount_ = 0, vertexCount_ = 0;
  const void* indexData_ = nullptr;                  // of triangles; null: triangle soup
  bool isSpecial_ = false;                           // impostors or user primitives
  std::shared_ptr<void> userData_;                   // of user primitives; bundles of capsules
  std::unique_ptr<Neighbours> neighbours_;           // null: it cannot be refitted
  std::unique_ptr<RTCSceneTy, ReleaseScene> scene_;  // the last member: it reads the others
};

}  // namespace gluray::accel
