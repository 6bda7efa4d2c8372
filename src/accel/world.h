// Everything rays can hit in a frame: meshes' structures, instances, queries. Owned by frame::Renderer, which
// calls update() between frames; render/ then queries it from all tracing threads.
#pragma once
#include "accel/memory/free_memory.h"
#include "accel/meshes/blas_cache.h"
#include "accel/meshes/coincidence.h"
#include "accel/meshes/triangle_sizes.h"
#include "accel/occlusion.h"
#include "accel/ray_packet.h"
#include "accel/tlas.h"
#include "parallel/arena.h"
#include "scene/snapshot.h"

#include <memory>
#include <vector>

namespace gluray::accel {

struct UpdateStatistics {
  uint64_t blasBuilds = 0, tlasBuilds = 0;  // by this call
  uint64_t blasRefits = 0;                  // of the builds: adjusted from earlier positions of a mesh
  uint64_t blasRefinements = 0;             // structures exchanged for better ones, built since the last call
};

/// Decides which hits count. Called on tracing threads.
class HitFilter {
 public:
  virtual ~HitFilter() = default;
  /// False: the ray goes on as if the triangle were not there. Barycentric u, v as in RayPacket.
  virtual bool accepts(uint32_t instance, uint32_t primitive, float u, float v, int lane) const noexcept = 0;
};

/// Which of several surfaces at one place is seen.
struct DrawOrder {
  std::vector<uint32_t> ranks;  // of Snapshot::instances, by when they were drawn
  bool laterWins = false;
};

class NextHits;
struct QueryState;

class World {
 public:
  /// `idleBudgetBytes`, `freeMemory`: see BlasCache. Throws Error where Embree does not start.
  explicit World(size_t idleBudgetBytes = size_t{512} << 20, FreeMemory = freeMemory);

  /// Makes the world hold the snapshot's instances, building what is new. Throws Error or std::bad_alloc:
  /// then nothing may be traced until an update succeeds.
  UpdateStatistics update(const scene::Snapshot&, Arena&);

  /// Nearest hits of the lanes with valid[i] = -1 (others 0), an array aligned to 64 bytes; the packet's hit
  /// fields must be cleared (geometry = kNoHit). Hits that `filter` refuses do not count; null: all do. Where
  /// triangles coincide, the hit is on the one that the snapshot's order of drawing and depth function leave.
  /// Without `impostors` there are none.
  void intersect(const int32_t* valid, RayPacket&, const HitFilter* filter = nullptr,
                 const ImpostorQuery* impostors = nullptr) const noexcept;

  /// The nearest hits of each of those lanes, NextHits::kMost at most, without those that the lane is done
  /// with; of triangles at one place all. The packet's own fields mean nothing afterwards.
  void intersectNext(const int32_t* valid, RayPacket&, NextHits&,
                     const ImpostorQuery* impostors) const noexcept;

  /// Nearest hits of rays from anywhere, which see impostors as solids (impostors/solid.h). Otherwise as
  /// intersect(); of triangles at one place any is hit.
  void intersectBounced(const int32_t* valid, RayPacket&) const noexcept;

  /// Bit i: something lies on ray i, of the lanes with valid[i] = -1 (others 0), an array aligned to 64 bytes.
  /// Both sides of surfaces block, culled or not; impostors block as solids. Surfaces that `filter` refuses do
  /// not; null: all do. Rays whose origin or direction is not finite or beyond what Embree takes, and those
  /// without length, meet nothing.
  uint32_t occluded(const int32_t* valid, OcclusionRays&, Coherence,
                    const OccluderFilter* filter = nullptr) const noexcept;

  /// Whether triangles may lie exactly upon each other.
  bool mayCoincide() const { return mayCoincide_; }
  /// True if there is nothing to hit.
  bool empty() const { return scene_ == nullptr; }
  /// True if some of it are impostors.
  bool hasImpostors() const { return !impostors_.empty(); }
  const PlacedImpostors& impostorsOf(uint32_t instance) const { return impostors_[instance]; }
  /// Bytes of all structures now.
  size_t bytes() const { return Device::bytes(); }
  size_t cachedBlases() const { return cache_.size(); }
  /// Whether a better structure is being built behind the frames.
  bool refining() const { return cache_.refining(); }
  /// Whether the next update() puts one in its place.
  bool refined() const { return cache_.refined(); }
  /// Bounding box of everything, world space. Only where not empty.
  glm::vec3 lower() const { return lower_; }
  glm::vec3 upper() const { return upper_; }
  /// The longest edge of a mesh's triangles, object space; 0 of impostors. Looks at each mesh once.
  float longestEdge(const scene::Mesh& mesh) const { return sizes_.longestEdge(mesh); }

 private:
  /// Whether the top level holds these, none of them further from its place than matrices of floats are
  /// rounded.
  bool stayPlaced(const scene::Snapshot& snapshot, const std::vector<PlacedBlas>& placed) const;
  std::vector<PlacedBlas> place(const scene::Snapshot&);
  std::vector<BlasPtr> structures(const std::vector<Geometry>&, BvhQuality);
  void ask(QueryState&, bool filtered, const int32_t* valid, RayPacket&, const ImpostorQuery*) const noexcept;
  void readBounds();
  void readOrder(const scene::Snapshot&);
  void readImpostors(const scene::Snapshot&);

  Device device_;
  BlasCache cache_;
  mutable TriangleSizes sizes_;
  Tlas tlas_;
  RTCSceneTy* scene_ = nullptr;  // what rays are traced in: the top level, or a lone mesh without transform
  BlasPtr alone_;
  uint32_t aloneIndex_ = 0;
  Coincidence coincidence_;
  bool mayCoincide_ = false;  // some triangles may: hits are compared, which costs time
  bool apart_ = false;        // none of what the top level holds may
  DrawOrder order_;
  std::vector<PlacedImpostors> impostors_;  // by instance; empty where all are triangles
  bool hasPixelImpostors_ = false;          // some of them have a size in pixels
  glm::vec3 lower_{0}, upper_{0};
};

}  // namespace gluray::accel
