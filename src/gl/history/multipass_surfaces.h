// Surfaces that a program draws several times in one depth epoch, for instance first depth alone, then
// colours with GL_EQUAL. Later passes compare with the exact depth of the first one, and traced depth differs
// from rasterised depth in the last bits. So such surfaces are rasterised in every pass. If the first pass
// was traced before a second one was known, the real OpenGL draws its depth again. If the first pass was
// rasterised for another reason, the second one is rasterised, too. So are passes that could be traced, but
// in different batches: depths of two tracings also differ in the last bits. Surfaces of the fixed-function
// pipeline are recognised by their modelview matrix. Surfaces of shader programs are recognised by their
// framebuffer and number of triangles, because the matrices of an unknown program are unknown. Owned by
// Context, GL thread.
#pragma once
#include "base/hash.h"
#include "gl/history/coincident_meshes.h"
#include "gl/history/depth_history.h"
#include "gl/history/sampled_surfaces.h"
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <memory_resource>
#include <optional>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace gluray::gl {

/// Bloom filter over a mesh's vertices: no false negatives, about 1/60 false positives.
class VertexSet {
 public:
  explicit VertexSet(const scene::Mesh& mesh);
  bool mayHold(const glm::vec3& point) const;

 private:
  struct Place {
    size_t word;
    uint64_t bits;
  };
  Place placeOf(const glm::vec3& point) const;
  std::vector<uint64_t> words_;
  glm::vec3 lower_, upper_;
};

/// A traced surface whose depth the real OpenGL must draw again.
struct DepthRedraw {
  scene::SnapshotPtr snapshot;  // the snapshot of its tracing, reduced to this surface
  scene::MeshPtr mesh;
  std::optional<glm::dmat4> clipFromObject;  // set if a shader program drew it
};

class MultipassSurfaces {
 public:
  enum class How : uint8_t { pending, traced, rasterised };  // pending: in the pending batch
  /// Reports that a surface was drawn in this depth epoch. `pushedBack`: with a polygon offset away from the
  /// viewer, so that an equal surface without offset passes the depth test against it.
  void drawn(const scene::MeshPtr& mesh, const glm::dmat4& eyeFromObject, How how, const DepthPlace& place,
             bool pushedBack);
  /// Reports a pending surface that a shader program draws.
  void drawnByProgram(const scene::MeshPtr& mesh, const glm::dmat4& eyeFromObject,
                      const glm::dmat4& clipFromObject, const DepthPlace& place, bool pushedBack);
  /// Reports that the pending batch was traced or, if `snapshot` is null, rasterised.
  void flushed(const scene::SnapshotPtr& snapshot);
  /// Reports that depth was cleared: a new depth epoch begins. Surfaces that the clear does not remove belong
  /// to it, too, for DepthHistory::kMaxTurns clears and frames.
  void clear(const DepthClear& depth);
  /// Reports a swap of buffers: a new, empty depth epoch begins.
  void clear();
  /// Reports the end of a frame without a swap, which keeps depth.
  void shown();
  /// Forgets the depth epoch if it has more than 65,536 surfaces: its depth may never be cleared.
  void forgetMany();
  /// Whether there is any surface that a clear could remove.
  bool remembers() const {
    return any() || sampled_.size() > 0 || !unsampledFixed_.empty() || !rasterisedByProgram_.empty() ||
           !unseen_.empty();
  }
  /// Whether a surface of drawnByProgram() has this framebuffer and number of triangles.
  bool anyByProgram(uint32_t framebuffer, uint64_t triangles) const;
  /// Whether surfaces other than those of rasterisedByProgram() were drawn in this depth epoch.
  bool any() const { return !surfaces_.empty(); }
  /// Whether any surface of the depth epoch was drawn with this modelview matrix.
  bool anyUnder(const glm::dmat4& eyeFromObject) const;

  /// Whether draws from fixed function's vertices must be reported by rasterisedFixed(): a surface that they
  /// could coincide with was traceable in one of the last hundred depth epochs. If not,
  /// addUnsampledFixedDraw() is enough.
  bool asksForFixed() const { return idle_ <= kRemembered; }
  /// Reports a surface that is rasterised from fixed function's vertices and leaves depth, with a sample of
  /// its triangles.
  void rasterisedFixed(const glm::dmat4& eyeFromObject, std::vector<Triangle> triangles,
                       const DepthPlace& place, bool pushedBack);
  /// Reports such a surface without a sample of its triangles: all traceable surfaces of fixed function that
  /// follow in the depth epoch count as coincident with it.
  void addUnsampledFixedDraw(const DepthPlace& place);
  /// Whether `mesh`, which would be traced there, coincides with a surface reported by
  /// rasterisedFixed() or addUnsampledFixedDraw(). The result is not remembered for later frames.
  bool meetsSampled(const scene::Mesh& mesh, const glm::dmat4& eyeFromObject, const DepthPlace& place,
                    bool pushedBack);
  /// Whether `mesh`, which could be traced, coincides with a surface of drawn() that was rasterised. If so,
  /// both are remembered as multipass.
  bool meetsRasterised(const scene::Mesh& mesh, const glm::dmat4& eyeFromObject, const DepthPlace& place,
                       bool pushedBack);

  /// Whether surfaces of an earlier batch were traced in this depth epoch.
  bool anyTraced() const { return traced_; }
  /// Whether `mesh`, in the pending batch, coincides with surfaces of earlier batches that were traced with
  /// the same camera and offset. A mesh that does not leave depth meets only other meshes: hits on the same
  /// one have equal depths. If so, all are remembered as multipass, and takeTraced() returns the earlier
  /// ones. `batch`: the pending batch's draws so far. Compares at most 65,536 pairs in a depth epoch.
  bool meetsTraced(const scene::MeshPtr& mesh, const glm::dmat4& eyeFromObject, const scene::Snapshot& batch,
                   const DepthPlace& place, bool leavesDepth);
  /// The same for a surface that a shader program draws.
  bool meetsTracedByProgram(const scene::MeshPtr& mesh, const glm::dmat4& clipFromObject,
                            const scene::Snapshot& batch, const DepthPlace& place, bool leavesDepth);

  enum class Meeting { none, drawn, pending };
  /// Whether one of the triangles about to be drawn coincides with one of an earlier surface of the depth
  /// epoch. Surfaces that were pushed back do not count unless the new ones are, too. The earlier surface is
  /// then remembered as multipass. `pending`: it is still in the pending batch.
  Meeting meets(const glm::dmat4& eyeFromObject, std::span<const Triangle> triangles, const DepthPlace& place,
                bool pushedBack);
  /// The same for a shader program's draw of `count` triangles. `triangles`: a sample of them;
  /// `clipFromObject`: null if unknown.
  Meeting meetsProgram(const DepthPlace& place, std::span<const Triangle> triangles, uint64_t count,
                       const glm::dmat4* clipFromObject, bool pushedBack);
  /// Reports that a shader program's draw of `count` triangles is rasterised and writes depth. `triangles`: a
  /// sample of them.
  void rasterisedByProgram(const DepthPlace& place, uint64_t count, std::vector<Triangle> triangles,
                           const glm::dmat4* clipFromObject, bool pushedBack);
  /// Reports such a draw without a sample, if no program was traced. Surfaces of `count` triangles that
  /// shader programs draw later in the depth epoch, into the same place, then count as coincident with it.
  void rasterisedUnseen(const DepthPlace& place, uint64_t count);
  /// Whether a surface that a shader program is about to draw coincides with one reported by
  /// rasterisedByProgram() or rasterisedUnseen(). If so, it is remembered as multipass.
  bool meetsRasterised(const DepthPlace& place, const scene::Mesh& mesh, const glm::dmat4& clipFromObject,
                       bool pushedBack);
  /// Returns the surfaces that meets() and meetsProgram() have found and that were already traced. From now
  /// on they count as rasterised.
  std::vector<DepthRedraw> takeTraced();
  /// Whether the geometry was remembered as multipass in this depth epoch or one of the last hundred.
  bool several(const Hash128& geometry);

 private:
  struct Surface {
    scene::MeshPtr mesh;
    glm::dmat4 eyeFromObject;
    How how;
    bool pushedBack;
    DepthStamp at;
    scene::SnapshotPtr snapshot = nullptr;          // the snapshot in which it was traced
    bool met = false;                               // another pass was found since takeTraced()
    std::optional<glm::dmat4> clipFromObject = {};  // set if a shader program drew it
  };
  struct Rasterised {
    DepthStamp at;
    uint64_t count;
    std::vector<Triangle> triangles;
    std::optional<glm::dmat4> clipFromObject;  // if known
    bool pushedBack;
  };
  static constexpr size_t kMaxRasterised = 1024;  // per depth epoch
  static constexpr uint64_t kRemembered = 100;    // depth epochs: seconds, or a few frames of many
  /// Key in surfaces_ of surfaces that shader programs draw into a framebuffer.
  static Hash128 placeIn(uint32_t framebuffer);
  /// Key in unseen_.
  static Hash128 unseenKey(const DepthPlace& place);  // by framebuffer and viewport
  /// Ends the depth epoch if it had surfaces.
  void endEpoch();
  /// Forgets all entries for which `gone(DepthStamp)` is true.
  template <class Gone>
  void forgetIf(const Gone& gone);
  void limit();
  /// Whether the matrices are equal and all corners of one of the triangles are vertices of the surface.
  bool liesUpon(const Surface& surface, const glm::dmat4& eyeFromObject, std::span<const Triangle> triangles);
  bool holdsSome(const scene::Mesh& mesh, std::span<const Triangle> triangles);
  static Meeting meet(Surface& surface, Meeting before);
  /// meetsTraced() for the surfaces that surfaces_ has under `key` and for which sameMatrix(surface) is true.
  template <class SameMatrix>
  bool meetsTracedUnder(const Hash128& key, const scene::MeshPtr& mesh, const scene::Snapshot& batch,
                        const DepthPlace& place, bool leavesDepth, const SameMatrix& sameMatrix);
  void remember(const Hash128& geometry);
  const VertexSet& verticesOf(const scene::Mesh& mesh);

  std::pmr::unsynchronized_pool_resource blocks_;  // reused: thousands of small allocations a frame
  std::pmr::unordered_multimap<Hash128, Surface> surfaces_{&blocks_};  // by modelview; programs': framebuffer
  bool rasterised_ = false;                                            // some surfaces were rasterised
  bool traced_ = false;                                                // some surfaces were traced
  uint64_t compared_ = 0;                                              // surfaces, by meetsTraced()
  CoincidentMeshes coincident_;
  bool used_ = false;  // a surface was drawn since endEpoch()
  DepthHistory depths_;
  std::vector<Rasterised> rasterisedByProgram_;
  // The last entry of rasterisedUnseen(), to skip repetitions: consecutive draws are often alike.
  struct Unseen {
    DepthPlace place;
    uint64_t count = 0;
    bool operator==(const Unseen&) const = default;
  };
  Unseen lastUnseen_;
  /// Triangle counts of the draws into one place.
  struct UnseenAt {
    DepthStamp at;
    std::unordered_set<uint64_t> counts;
  };
  std::unordered_map<Hash128, UnseenAt> unseen_;  // by place
  size_t unseenCounts_ = 0;                       // inserted since the last clear()
  SampledSurfaces sampled_;                       // of rasterisedFixed()
  // Draws of addUnsampledFixedDraw(), by framebuffer; the region contains all of them.
  std::unordered_map<uint32_t, DepthStamp> unsampledFixed_;
  uint64_t idle_ = 0;  // depth epochs since a surface of fixed function's vertices could be traced
  uint64_t epoch_ = 0;
  std::unordered_map<Hash128, uint64_t> metIn_;  // geometry -> last epoch with several passes
  std::unordered_map<Hash128, std::unique_ptr<VertexSet>> vertices_;  // by geometry
};

}  // namespace gluray::gl
