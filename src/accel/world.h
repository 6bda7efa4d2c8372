// The scene that rays are traced in: BLASes, TLAS, queries. Owned by frame::Renderer, which calls update()
// between frames; render/ then queries it from all tracing threads.
#pragma once
#include "accel/cache/blas_cache.h"
#include "accel/ground.h"
#include "accel/light_scene.h"
#include "accel/memory/free_memory.h"
#include "accel/meshes/coincidence.h"
#include "accel/meshes/triangle_sizes.h"
#include "accel/pages/page_cache.h"
#include "accel/rays/draw_order.h"
#include "accel/rays/hit_filter.h"
#include "accel/rays/occlusion.h"
#include "accel/rays/ray_packet.h"
#include "accel/tlas.h"
#include "parallel/arena.h"
#include "scene/snapshot.h"

#include <memory>
#include <vector>

namespace gluray::accel {

struct UpdateStatistics {
  uint64_t blasBuilds = 0, tlasBuilds = 0;  // by this call
  uint64_t blasRefits = 0;                  // of blasBuilds: refitted from earlier positions of a mesh
  uint64_t blasRefinements = 0;             // fast BLASes replaced by full ones, built in the background
};

class NextHits;
struct QueryState;

class World {
 public:
  /// `idleBudgetBytes`, `freeMemory`: see BlasCache. Throws Error if Embree cannot start.
  explicit World(size_t idleBudgetBytes = size_t{512} << 20, FreeMemory = freeMemory);

  /// Replaces the contents by the snapshot's instances and builds missing structures. Throws Error or
  /// std::bad_alloc: then nothing may be traced until an update succeeds. Primary rays hit only these
  /// instances. occluded() and intersectBounced() also hit the snapshot's secondary scene, whose instances
  /// have the following numbers. Surfaces of the secondary scene that cannot be built are omitted. Rays do
  /// not hit instances in `hidden`; BLASes do not depend on `hidden`.
  UpdateStatistics update(const scene::Snapshot&, Arena&, const HiddenFrom& hidden = {});

  /// Finds the nearest hit of each lane with valid[i] = -1 (others 0). `valid` is aligned to 64 bytes; the
  /// packet's hit fields must be cleared (geometry = kNoHit). Ignores hits that `filter` rejects; null
  /// accepts all. Where triangles coincide, the hit is on the one that the snapshot's order of drawing and
  /// depth function leave. Without `impostors` rays hit no impostors.
  void intersect(const int32_t* valid, RayPacket&, const HitFilter* filter = nullptr,
                 const ImpostorQuery* impostors = nullptr,
                 Coherence coherence = Coherence::coherent) const noexcept;

  /// Finds up to NextHits::kMax nearest hits of each valid lane, except those already passed on. Of
  /// coincident triangles it reports all. The packet's own fields are undefined afterwards.
  void intersectNext(const int32_t* valid, RayPacket&, NextHits&, const ImpostorQuery* impostors,
                     Coherence coherence = Coherence::coherent) const noexcept;

  /// Finds the nearest hits of secondary rays, which hit impostors as solids (impostors/solid.h), and the
  /// secondary scene. Otherwise like intersect(), but reports any of coincident triangles.
  void intersectBounced(const int32_t* valid, RayPacket&) const noexcept;

  /// Returns bit i if a surface blocks ray i, for lanes with valid[i] = -1 (others 0). `valid` is aligned to
  /// 64 bytes. Both sides of surfaces block, culled or not; impostors block as solids. Surfaces that `filter`
  /// rejects do not block; null: all block. Rays without length, or with values that are not finite or exceed
  /// Embree's range, hit nothing. `kind`: shadow or occlusion.
  uint32_t occluded(const int32_t* valid, OcclusionRays&, const OccluderFilter* filter = nullptr,
                    RayKind kind = RayKind::shadow) const noexcept;

  /// Whether triangles may coincide.
  bool mayCoincide() const { return mayCoincide_; }
  /// True if there is nothing to hit.
  bool empty() const { return scene_ == nullptr && !ground_.exists(); }
  /// Whether primary rays may hit impostors.
  bool hasImpostors() const { return hasImpostors_; }
  const PlacedImpostors& impostorsOf(uint32_t instance) const { return impostors_[instance]; }
  /// Frees the structures of meshes that no longer exist.
  void releaseOrphans() { cache_.evictOrphans(); }
  /// Bytes of all structures at present.
  size_t bytes() const { return Device::bytes(); }
  size_t cachedBlases() const { return cache_.size(); }
  /// Whether a full-quality BLAS is being built in the background.
  bool refining() const { return cache_.refining(); }
  /// Whether the next update() will install a finished full-quality BLAS.
  bool refined() const { return cache_.refined(); }
  /// Bounding box of the instances for primary rays, without the ground, world space. Requires !empty().
  glm::vec3 lower() const { return lower_; }
  glm::vec3 upper() const { return upper_; }
  /// That bounding box, including the ground.
  Bounds seenBounds() const {
    Bounds bounds{lower_, upper_};
    ground_.extend(bounds.lower, bounds.upper);
    return bounds;
  }
  /// Bounding box of the scene of secondary rays without the ground, in the space of
  /// SecondaryScene::viewFromWorld.
  Bounds lightBounds() const { return light_.exists() ? light_.bounds() : Bounds{lower_, upper_}; }
  /// Cache of the pages of meshes. Any thread.
  PageCache& pages() const { return pages_; }
  /// The longest triangle edge of a mesh, object space; 0 for impostors. Computed once per mesh.
  float longestEdge(const scene::Mesh& mesh) const { return sizes_.longestEdge(mesh); }

 private:
  std::vector<PlacedBlas> placeInstances(const scene::Snapshot&);
  bool placeAround(const scene::Snapshot&, const std::vector<PlacedBlas>& drawn, const HiddenFrom&);
  RTCSceneTy* lightScene(RayKind kind) const { return light_.exists() ? light_.scene(kind) : scene_; }
  std::vector<BlasPtr> structures(const std::vector<Geometry>&, BvhQuality);
  void ask(QueryState&, bool filtered, const int32_t* valid, RayPacket&, const ImpostorQuery*,
           Coherence) const noexcept;
  bool chooseScene(const scene::Snapshot&, std::vector<PlacedBlas> placed, UpdateStatistics&);
  void release();
  void releaseUnused();
  void readBounds();
  void readOrder(const scene::Snapshot&, bool fromTopLevel);
  void readImpostors(const scene::Snapshot&);

  Device device_;
  mutable PageCache pages_;  // outlives the structures
  BlasCache cache_;
  mutable TriangleSizes sizes_;
  Tlas tlas_;
  LightScene light_;
  Ground ground_;
  RTCSceneTy* scene_ = nullptr;  // traced: the TLAS, or the BLAS of a single untransformed mesh
  BlasPtr alone_;
  uint32_t aloneIndex_ = 0;
  Coincidence coincidence_;
  bool mayCoincide_ = false;               // triangles may coincide: hits are compared, which costs time
  bool apart_ = false;                     // the TLAS holds no triangles that may coincide
  uint64_t tlasUsed_ = 0, lightUsed_ = 0;  // BlasCache::frames() at the last use of their contents
  DrawOrder order_;
  std::vector<PlacedImpostors> impostors_;  // per instance; empty if all are triangles
  bool hasImpostors_ = false;               // some of the snapshot's own instances are
  bool hasPixelImpostors_ = false;          // some have a size in pixels
  glm::vec3 lower_{0}, upper_{0};
};

}  // namespace gluray::accel
