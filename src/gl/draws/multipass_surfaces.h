// Surfaces that a program draws several times in one depth epoch, for instance first depth alone, then
// colours with GL_EQUAL. Later passes compare with the depth of the first one, to the bit, and traced depth
// differs from rasterised depth in the last bits. So such surfaces are rasterised in every pass. Where the
// first pass was traced before a second one was known, its depth is drawn again by the real OpenGL.
// Surfaces of the fixed-function pipeline are recognised by their modelview matrix. Surfaces of shader
// programs are recognised by their framebuffer and number of triangles, because the matrices of an unknown
// program are unknown. Owned by Context, GL thread.
#pragma once
#include "base/hash.h"
#include "gl/capture/captured_vertices.h"
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <memory_resource>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace gluray::gl {

/// Corners in object space.
using Triangle = std::array<glm::vec3, 3>;

/// Some triangles of a mesh, or of captured surfaces, spread over them.
std::vector<Triangle> sampleTriangles(const scene::Mesh& mesh);
std::vector<Triangle> sampleTriangles(const CapturedVertices& captured);

/// The vertices of a mesh as a Bloom filter, 1/60 false positives.
class VertexSet {
 public:
  explicit VertexSet(const scene::Mesh& mesh);
  /// False: the point is no vertex of the mesh.
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

/// A surface whose depth is to be drawn again.
struct DepthRedraw {
  scene::SnapshotPtr snapshot;  // what was traced, without other surfaces
  scene::MeshPtr mesh;
  std::optional<glm::dmat4> clipFromObject;  // of a shader program that took this matrix
};

class MultipassSurfaces {
 public:
  enum class How : uint8_t { pending, traced, rasterised };  // pending: in a batch that waits to be traced
  /// A surface was drawn in this depth epoch; `pushedBack`: by a polygon offset, so that what comes without
  /// one wins.
  void drawn(const scene::MeshPtr& mesh, const glm::dmat4& eyeFromObject, How how, bool pushedBack);
  /// The same of a surface that a shader program draws, into `framebuffer`; it waits to be traced.
  void drawnByProgram(const scene::MeshPtr& mesh, const glm::dmat4& eyeFromObject,
                      const glm::dmat4& clipFromObject, uint32_t framebuffer, bool pushedBack);
  /// The pending batch was traced or, where `snapshot` is null, rasterised.
  void flushed(const scene::SnapshotPtr& snapshot);
  /// Depth of `framebuffer` was cleared, or the frame ended: a new depth epoch begins.
  void clear(std::optional<uint32_t> framebuffer = {});
  /// Forgets the depth epoch where it has more surfaces than frames have: nobody may ever clear its depth.
  void forgetMany();
  /// Whether shader programs have drawn surfaces of the depth epoch.
  bool anyByProgram() const { return byProgram_ || !rasterisedByProgram_.empty(); }
  /// Whether one of these, in `framebuffer`, has so many triangles.
  bool anyByProgram(uint32_t framebuffer, uint64_t triangles) const;
  /// Whether any surface of the depth epoch was drawn with this modelview matrix.
  bool anyUnder(const glm::dmat4& eyeFromObject) const;

  /// Whether `mesh`, which could be traced, lies upon a surface of the depth epoch that was rasterised. Both
  /// are then remembered.
  bool meetsRasterised(const scene::Mesh& mesh, const glm::dmat4& eyeFromObject, bool pushedBack);

  enum class Meeting { none, drawn, pending };
  /// Whether one of the triangles, about to be drawn, lies upon a surface of the epoch that was not pushed
  /// back further; that surface is remembered as drawn in several passes. `pending`: it still waits to be
  /// traced.
  Meeting meets(const glm::dmat4& eyeFromObject, std::span<const Triangle> triangles, bool pushedBack);
  /// The same of what a shader program is about to draw: some triangles of `count`, and where it puts them,
  /// if that is known.
  Meeting meetsProgram(uint32_t framebuffer, std::span<const Triangle> triangles, uint64_t count,
                       const glm::dmat4* clipFromObject, bool pushedBack);
  /// A shader program's draw of `count` triangles, some of which are given, is rasterised into `framebuffer`
  /// and leaves depth.
  void rasterisedByProgram(uint32_t framebuffer, uint64_t count, std::vector<Triangle> triangles,
                           const glm::dmat4* clipFromObject, bool pushedBack);
  /// Whether a surface that a shader program is about to draw lies upon one of these; it is remembered as
  /// drawn in several passes.
  bool meetsRasterised(uint32_t framebuffer, const scene::Mesh& mesh, const glm::dmat4& clipFromObject,
                       bool pushedBack);
  /// The surfaces that meets() and meetsProgram() have found to be traced already, each once. They count as
  /// rasterised from then on.
  std::vector<DepthRedraw> takeTraced();
  /// Whether the geometry was found to be drawn in several passes, in this depth epoch or one of the last
  /// hundred.
  bool several(const Hash128& geometry);

 private:
  struct Surface {
    scene::MeshPtr mesh;
    glm::dmat4 eyeFromObject;
    How how;
    bool pushedBack;
    scene::SnapshotPtr snapshot = nullptr;          // that it was traced in
    bool met = false;                               // by a pass, since takeTraced()
    std::optional<glm::dmat4> clipFromObject = {};  // of a shader program
  };
  struct Rasterised {
    uint32_t framebuffer;
    uint64_t count;
    std::vector<Triangle> triangles;
    std::optional<glm::dmat4> clipFromObject;  // if it is known
    bool pushedBack;
  };
  static constexpr size_t kMostRasterised = 1024;  // in a depth epoch
  /// Whether one of the triangles has all its corners among the surface's.
  bool liesUpon(const Surface& surface, const glm::dmat4& eyeFromObject, std::span<const Triangle> triangles);
  bool holdsSome(const scene::Mesh& mesh, std::span<const Triangle> triangles);
  static Meeting meet(Surface& surface, Meeting before);
  void remember(const Hash128& geometry);
  const VertexSet& verticesOf(const scene::Mesh& mesh);

  std::pmr::unsynchronized_pool_resource blocks_;  // thousands of small ones a frame, again and again
  std::pmr::unordered_multimap<Hash128, Surface> surfaces_{&blocks_};  // by matrix
  bool rasterised_ = false;                                            // some of them were
  bool byProgram_ = false;                                             // some are of shader programs
  std::vector<Rasterised> rasterisedByProgram_;
  uint64_t epoch_ = 0;
  std::unordered_map<Hash128, uint64_t> metIn_;  // geometry -> last epoch in which a pass met it
  std::unordered_map<Hash128, std::unique_ptr<VertexSet>> vertices_;  // by geometry
};

}  // namespace gluray::gl
