// Finds planar meshes of different draws that lie in one plane and overlap in the window. OpenGL's result
// depends on their order and on how its rasteriser rounds the depths that it interpolates between vertices,
// which rays cannot reproduce. So both are rasterised. Owned by Context, GL thread.
#pragma once
#include "base/hash.h"
#include "gl/history/depth_history.h"
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace gluray::gl {

/// Where a draw places its mesh.
struct SurfacePlace {
  DepthPlace at;
  glm::dmat4 clipFromObject{1};
  scene::PolygonOffset offset;  // its `resolution` is the framebuffer's depth resolution
};

class CoplanarSurfaces {
 public:
  /// Whether `mesh`, which is about to be drawn and could be traced, is planar and overlaps another planar
  /// mesh of the depth epoch in its plane, or did so in one of the last hundred epochs. Equal triangles do
  /// not count, because their depths are equal. Ignores meshes of more than kMaxTriangles triangles. At most
  /// kMaxPlanarMeshes planar meshes are compared in a depth epoch; meshes of earlier epochs are forgotten
  /// first.
  bool meets(const scene::MeshPtr& mesh, const SurfacePlace& place);
  /// Whether, since the last call, a mesh drawn in this depth epoch was first found to overlap another.
  bool takeFound() { return std::exchange(found_, false); }
  /// Reports that depth was cleared: a new depth epoch begins. It keeps the meshes that the clear does not
  /// remove.
  void clear(const DepthClear& depth);
  /// Reports a swap of buffers: a new, empty depth epoch begins.
  void clear();
  /// Reports the end of a frame without a swap, which keeps depth.
  void shown() { depths_.nextTurn(), endEpoch(); }
  bool empty() const { return planar_.empty(); }
  /// Work of this depth epoch: triangles read plus bounding boxes compared (a pair of triangles counts as 8).
  uint64_t work() const { return work_; }

  static constexpr uint32_t kMaxTriangles = 4096;
  static constexpr size_t kMaxPlanarMeshes = 512;
  /// Limit of work() in a depth epoch. Beyond it, planar meshes count as overlapping if their bounds in one
  /// plane overlap.
  static constexpr uint64_t kMaxWork = 1 << 20;

 private:
  /// In normalised device coordinates; depth is x*plane.x + y*plane.y + plane.z.
  struct PlanarMesh {
    scene::MeshPtr mesh;
    SurfacePlace place;
    glm::dvec3 plane;
    glm::ivec2 axes;           // the two object-space axes used as coordinates (s, t) in its plane
    glm::dmat3 clipFromPlane;  // clip x, y and w from (s, t, 1)
    glm::dvec2 lower, upper;   // its bounds, clipped to the pixels that it may cover
    bool before = true;        // all of it is in front of the viewer
    uint64_t epoch = 0;        // depth epoch in which it was drawn
    DepthStamp at;
  };
  struct Piece;
  struct Common;

  static std::optional<PlanarMesh> placed(const scene::MeshPtr& mesh, const SurfacePlace& place,
                                          const glm::dvec4& plane);
  /// The triangles of `planar` that reach into `common`; `commonFromPlane` maps its (s, t, 1) to the (s, t,
  /// 1) of `common`.
  static std::vector<Piece> piecesOf(const PlanarMesh& planar, const glm::dmat3& commonFromPlane,
                                     const Common& common);
  bool overlap(const PlanarMesh& a, const PlanarMesh& b);
  /// Whether a triangle of `a` overlaps a triangle of `b` that is not equal to it. Sweeps along x.
  bool anyOverlap(std::vector<Piece> a, std::vector<Piece> b);
  /// The plane of the mesh in object space; nullopt if it is not planar.
  const std::optional<glm::dvec4>& planeOf(const scene::Mesh& mesh);
  /// Ends the depth epoch if it had planar meshes.
  void endEpoch();
  /// Whether another mesh may be added. Forgets meshes of earlier epochs if there are too many.
  bool hasRoom();
  void remember(const Hash128& geometry);
  bool isRemembered(const Hash128& geometry);

  std::vector<PlanarMesh> planar_;  // not removed by a clear yet
  DepthHistory depths_;
  bool used_ = false;  // a planar mesh was drawn in this depth epoch
  bool found_ = false;
  uint64_t epoch_ = 0, work_ = 0;
  std::unordered_map<Hash128, uint64_t> metIn_;                    // geometry -> last depth epoch
  std::unordered_map<Hash128, std::optional<glm::dvec4>> planes_;  // by geometry
};

}  // namespace gluray::gl
