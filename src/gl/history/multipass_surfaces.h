// Surfaces that a program draws several times in one depth epoch, for instance first depth alone, then
// colours with GL_EQUAL. Later passes compare with the depth of the first one, to the bit, and traced depth
// differs from rasterised depth in the last bits. So such surfaces are rasterised in every pass. Where the
// first pass was traced before a second one was known, its depth is drawn again by the real OpenGL. Where the
// first pass was rasterised for another reason, the second one is rasterised, too.
// Surfaces of the fixed-function pipeline are recognised by their modelview matrix. Surfaces of shader
// programs are recognised by their framebuffer and number of triangles, because the matrices of an unknown
// program are unknown. Owned by Context, GL thread.
#pragma once
#include "base/hash.h"
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
  scene::SnapshotPtr snapshot;  // the one it was traced in, reduced to this surface
  scene::MeshPtr mesh;
  std::optional<glm::dmat4> clipFromObject;  // set if a shader program drew it
};

class MultipassSurfaces {
 public:
  enum class How : uint8_t { pending, traced, rasterised };  // pending: in the pending batch
  /// A surface was drawn in this depth epoch. `pushedBack`: with a polygon offset away from the viewer, so
  /// that a surface without offset wins over it.
  void drawn(const scene::MeshPtr& mesh, const glm::dmat4& eyeFromObject, How how, const DepthPlace& place,
             bool pushedBack);
  /// The same for a pending surface that a shader program draws.
  void drawnByProgram(const scene::MeshPtr& mesh, const glm::dmat4& eyeFromObject,
                      const glm::dmat4& clipFromObject, const DepthPlace& place, bool pushedBack);
  /// The pending batch was traced or, where `snapshot` is null, rasterised.
  void flushed(const scene::SnapshotPtr& snapshot);
  /// Depth was cleared: a new depth epoch begins. What the clear does not remove belongs to it, too, for
  /// DepthHistory::kMaxTurns clears and frames.
  void clear(const DepthClear& depth);
  /// Buffers were swapped: a new depth epoch begins with nothing.
  void clear();
  /// A frame ended without a swap, which leaves its depth as it is.
  void shown();
  /// Forgets the depth epoch if it has more than 65,536 surfaces: its depth may never be cleared.
  void forgetMany();
  /// Whether it has anything that a clear could remove.
  bool remembers() const {
    return any() || sampled_.size() > 0 || !unsampledFixed_.empty() || !rasterisedByProgram_.empty() ||
           !unseen_.empty();
  }
  /// Whether one of these that was not rasterised at once has this framebuffer and number of triangles.
  bool anyByProgram(uint32_t framebuffer, uint64_t triangles) const;
  /// Whether surfaces were drawn in this depth epoch, beside those of rasterisedByProgram().
  bool any() const { return !surfaces_.empty(); }
  /// Whether any surface of the depth epoch was drawn with this modelview matrix.
  bool anyUnder(const glm::dmat4& eyeFromObject) const;

  /// Whether rasterisedFixed() gets the surfaces that are drawn from fixed function's vertices: there were
  /// traced ones, with which they could coincide, in this depth epoch or one of the last hundred. If not,
  /// call addUnsampledFixedDraw().
  bool asksForFixed() const { return idle_ <= kRemembered; }
  /// A surface of which a sample of triangles is given is rasterised from fixed function's vertices and
  /// leaves depth.
  void rasterisedFixed(const glm::dmat4& eyeFromObject, std::vector<Triangle> triangles,
                       const DepthPlace& place, bool pushedBack);
  /// Adds such a surface without a sample of its triangles: all traceable surfaces of fixed function that
  /// follow in the depth epoch count as coincident with it.
  void addUnsampledFixedDraw(const DepthPlace& place);
  /// Whether `mesh`, which would be traced into `framebuffer`, coincides with one of these. Later frames find
  /// that anew.
  bool meetsSampled(const scene::Mesh& mesh, const glm::dmat4& eyeFromObject, uint32_t framebuffer,
                    bool pushedBack);
  /// Whether `mesh`, which could be traced, coincides with a surface of drawn() that was rasterised. Both are
  /// then remembered as multipass.
  bool meetsRasterised(const scene::Mesh& mesh, const glm::dmat4& eyeFromObject, uint32_t framebuffer,
                       bool pushedBack);

  enum class Meeting { none, drawn, pending };
  /// Whether one of the triangles about to be drawn coincides with one of an earlier surface of the depth
  /// epoch; surfaces that were pushed back while these are not do not count. The surface is then remembered
  /// as multipass. `pending`: it is still in the pending batch.
  Meeting meets(const glm::dmat4& eyeFromObject, std::span<const Triangle> triangles, uint32_t framebuffer,
                bool pushedBack);
  /// The same for a shader program's draw of `count` triangles, of which a sample is given; `clipFromObject`
  /// is null if unknown.
  Meeting meetsProgram(uint32_t framebuffer, std::span<const Triangle> triangles, uint64_t count,
                       const glm::dmat4* clipFromObject, bool pushedBack);
  /// A shader program's draw of `count` triangles, of which a sample is given, is rasterised and writes
  /// depth.
  void rasterisedByProgram(const DepthPlace& place, uint64_t count, std::vector<Triangle> triangles,
                           const glm::dmat4* clipFromObject, bool pushedBack);
  /// The same for a draw of which no sample was taken, because no program was traced: all surfaces of as many
  /// triangles that shader programs draw later in the depth epoch, into the same place, count as coinciding
  /// with it.
  void rasterisedUnseen(const DepthPlace& place, uint64_t count);
  /// Whether a surface that a shader program is about to draw coincides with one of these; it is then
  /// remembered as multipass.
  bool meetsRasterised(const DepthPlace& place, const scene::Mesh& mesh, const glm::dmat4& clipFromObject,
                       bool pushedBack);
  /// Takes the surfaces that meets() and meetsProgram() have found and that were traced already. They count
  /// as rasterised from then on.
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
    scene::SnapshotPtr snapshot = nullptr;          // the one it was traced in
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
  static constexpr uint64_t kRemembered = 100;  // depth epochs: some seconds, or a few frames of many epochs
  /// Ends the depth epoch if it had surfaces.
  void endEpoch();
  /// Forgets what `gone(DepthStamp)`.
  template <class Gone>
  void forgetIf(const Gone& gone);
  void limit();
  /// Whether the matrices are equal and all corners of one of the triangles are vertices of the surface.
  bool liesUpon(const Surface& surface, const glm::dmat4& eyeFromObject, std::span<const Triangle> triangles);
  bool holdsSome(const scene::Mesh& mesh, std::span<const Triangle> triangles);
  static Meeting meet(Surface& surface, Meeting before);
  void remember(const Hash128& geometry);
  const VertexSet& verticesOf(const scene::Mesh& mesh);

  std::pmr::unsynchronized_pool_resource blocks_;  // reused: thousands of small allocations a frame
  std::pmr::unordered_multimap<Hash128, Surface> surfaces_{&blocks_};  // by modelview; programs': framebuffer
  bool rasterised_ = false;                                            // some surfaces were rasterised
  bool used_ = false;                                                  // some were drawn since endEpoch()
  DepthHistory depths_;
  std::vector<Rasterised> rasterisedByProgram_;
  // Of rasterisedUnseen(), once each: draws that follow each other are often alike.
  struct Unseen {
    DepthPlace place;
    uint64_t count = 0;
    bool operator==(const Unseen&) const = default;
  };
  Unseen lastUnseen_;
  /// Numbers of triangles of what was drawn into one place.
  struct UnseenAt {
    DepthStamp at;
    std::unordered_set<uint64_t> counts;
  };
  std::unordered_map<Hash128, UnseenAt> unseen_;  // by place
  size_t unseenCounts_ = 0;                       // inserted since the last clear()
  SampledSurfaces sampled_;                       // of rasterisedFixed()
  // Of addUnsampledFixedDraw(), by framebuffer; the viewport contains all of them.
  std::unordered_map<uint32_t, DepthStamp> unsampledFixed_;
  uint64_t idle_ = 0;  // depth epochs since a surface of fixed function's vertices could be traced
  uint64_t epoch_ = 0;
  std::unordered_map<Hash128, uint64_t> metIn_;  // geometry -> last epoch with several passes
  std::unordered_map<Hash128, std::unique_ptr<VertexSet>> vertices_;  // by geometry
};

}  // namespace gluray::gl
