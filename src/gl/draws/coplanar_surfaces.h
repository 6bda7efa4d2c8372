// Planar meshes of different draws that lie in one plane and overlap in the window. Which of them
// OpenGL shows depends on their order and on how its rasteriser rounds depths that it computes from other
// vertices, so rays cannot tell: both are rasterised. Owned by Context, GL thread.
#pragma once
#include "base/hash.h"
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace gluray::gl {

/// Where a draw puts its mesh.
struct SurfacePlace {
  uint32_t framebuffer = 0;
  glm::ivec4 viewport{0};
  glm::dmat4 clipFromObject{1};
  scene::PolygonOffset offset;  // `resolution`: also that of the framebuffer
};

class CoplanarSurfaces {
 public:
  /// Whether `mesh`, which is about to be drawn and could be traced, is a planar mesh that overlaps another
  /// of the depth epoch in its plane, or was found to be one in the last hundred epochs. Triangles that are
  /// equal do not count: their depths are. Meshes of more than kMostTriangles, and planar meshes after the
  /// first kMostPlanarMeshes of a depth epoch, are not looked at.
  bool meets(const scene::MeshPtr& mesh, const SurfacePlace& place);
  /// Whether something drawn in this depth epoch was found to meet a planar mesh for the first time, since
  /// the last call.
  bool takeFound() { return std::exchange(found_, false); }
  /// Depth was cleared, or the frame ended: a new depth epoch begins.
  void clear();
  /// Triangles that were read, and pairs of them that were compared, to tell planar meshes of this depth
  /// epoch apart.
  uint64_t work() const { return work_; }

  static constexpr uint32_t kMostTriangles = 4096;
  static constexpr size_t kMostPlanarMeshes = 512;
  /// Of a depth epoch. Beyond it planar meshes whose bounds overlap in one plane are taken for overlapping.
  static constexpr uint64_t kMostWork = 1 << 20;

 private:
  /// In normalised device coordinates; depth is x*plane.x + y*plane.y + plane.z.
  struct PlanarMesh {
    scene::MeshPtr mesh;
    SurfacePlace place;
    glm::dvec3 plane;
    glm::ivec2 axes;           // of object space: the two coordinates that tell points of its plane apart
    glm::dmat3 clipFromPlane;  // x, y and w from these two and 1
    glm::dvec2 lower, upper;   // it reaches no farther inside the viewport
    bool before = true;        // all of it is before the viewer
  };
  struct Piece;
  struct Common;

  static std::optional<PlanarMesh> placed(const scene::MeshPtr& mesh, const SurfacePlace& place,
                                          const glm::dvec4& plane);
  /// The triangles of `planar mesh` that reach into `common`, whose plane has `commonFromPlane`.
  static std::vector<Piece> piecesOf(const PlanarMesh& planar, const glm::dmat3& commonFromPlane,
                                     const Common& common);
  bool overlap(const PlanarMesh& a, const PlanarMesh& b);
  /// Whether some triangle of `a` overlaps one of `b` that is not equal.
  bool anyOverlap(std::vector<Piece> a, std::vector<Piece> b);
  /// The plane of a mesh, object space; nothing where it is none.
  const std::optional<glm::dvec4>& planeOf(const scene::Mesh& mesh);
  void remember(const Hash128& geometry);
  bool isRemembered(const Hash128& geometry);

  std::vector<PlanarMesh> planar_;  // of this depth epoch
  bool found_ = false;
  uint64_t epoch_ = 0, work_ = 0;
  std::unordered_map<Hash128, uint64_t> metIn_;                    // geometry -> last depth epoch
  std::unordered_map<Hash128, std::optional<glm::dvec4>> planes_;  // by geometry
};

}  // namespace gluray::gl
