#include "gl/history/coplanar_surfaces.h"

#include "gl/history/mesh_plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gluray::gl {
namespace {

constexpr double kNarrow = 1e-5;  // NDC; overlaps narrower than this cover no visible sample

using Corners = std::array<glm::dvec3, 3>;

/// Whether an edge of `a` separates it from `b` in the window.
bool isApart(const Corners& a, const Corners& b) {
  for (size_t k = 0; k < 3; ++k) {
    const glm::dvec2 start(a[k]), edge = glm::dvec2(a[(k + 1) % 3]) - start;
    const auto beside = [&](const glm::dvec3& p) {
      return edge.x * (p.y - start.y) - edge.y * (p.x - start.x);
    };
    const double side = beside(a[(k + 2) % 3]) < 0 ? -1 : 1;
    const double most = std::max({side * beside(b[0]), side * beside(b[1]), side * beside(b[2])});
    if (most <= 0 || most * most <= kNarrow * kNarrow * glm::dot(edge, edge)) return true;
  }
  return false;
}

/// Whether the corners are the same, in any order.
bool isSame(const Corners& a, const Corners& b) {
  return std::all_of(a.begin(), a.end(),
                     [&](const glm::dvec3& p) { return std::find(b.begin(), b.end(), p) != b.end(); });
}

struct Box2 {
  glm::dvec2 lower{std::numeric_limits<double>::infinity()};
  glm::dvec2 upper{-std::numeric_limits<double>::infinity()};
  void add(const glm::dvec2& p) { lower = glm::min(lower, p), upper = glm::max(upper, p); }
  /// Whether the boxes overlap by more than `narrow` in both directions.
  bool meets(const Box2& other, const glm::dvec2& narrow) const {
    const glm::dvec2 size = glm::min(upper, other.upper) - glm::max(lower, other.lower);
    return size.x > narrow.x && size.y > narrow.y;
  }
};

/// The bounds of a mesh along two of its axes.
Box2 boundsOf(const scene::Mesh& mesh, const glm::ivec2& axes) {
  return {{mesh.lower[axes.x], mesh.lower[axes.y]}, {mesh.upper[axes.x], mesh.upper[axes.y]}};
}

std::array<glm::dvec3, 4> cornersOf(const Box2& box) {
  return {glm::dvec3(box.lower, 1), glm::dvec3(box.upper, 1), glm::dvec3(box.lower.x, box.upper.y, 1),
          glm::dvec3(box.upper.x, box.lower.y, 1)};
}

}  // namespace

/// A triangle in normalised device coordinates.
struct CoplanarSurfaces::Piece {
  Corners at;
  Box2 box;
};

/// The intersection of the bounds of two planar meshes, in (s, t) of the first one's plane. Neighbours that
/// touch have an empty intersection, however the plane is tilted in the window.
struct CoplanarSurfaces::Common {
  Box2 box;
  glm::dvec2 narrow{0};
};

std::optional<CoplanarSurfaces::PlanarMesh> CoplanarSurfaces::placed(const scene::MeshPtr& mesh,
                                                                     const SurfacePlace& place,
                                                                     const glm::dvec4& plane) {
  const glm::dvec4 clip = glm::transpose(glm::inverse(place.clipFromObject)) * plane;
  const glm::ivec2 axes = axesOfPlane(plane);
  PlanarMesh planar{mesh,
                    place,
                    {-clip.x / clip.z, -clip.y / clip.z, -clip.w / clip.z},
                    axes,
                    clipFromPlane(place.clipFromObject, plane, axes),
                    glm::dvec2(-1),
                    glm::dvec2(1)};
  // Seen edge-on, the mesh covers nothing.
  for (int c = 0; c < 3; ++c)
    if (!(std::abs(planar.plane[c]) < 1e9)) return std::nullopt;
  Box2 box;
  const auto add = [&](const glm::dvec3& p) {
    planar.before = planar.before && p.z > 0;
    box.add(glm::dvec2(p) / p.z);
  };
  for (const glm::dvec3& corner : cornersOf(boundsOf(*mesh, axes))) add(planar.clipFromPlane * corner);
  if (!planar.before) {  // the triangles may be in front of the viewer even if their bounds are not
    planar.before = true, box = {};
    for (uint32_t i = 0; i < 3 * mesh->triangleCount && planar.before; ++i) {
      const glm::dvec4 p = place.clipFromObject * glm::dvec4(cornerOf(*mesh, i / 3, i % 3), 1);
      add({p.x, p.y, p.w});
    }
  }
  if (planar.before) {
    const glm::dvec4 viewport(place.at.viewport);
    const scene::Region& r = place.at.region;
    const auto toNdc = [&](const glm::dvec2& pixel) {
      return 2.0 * (pixel - glm::dvec2(viewport)) / glm::dvec2(viewport.z, viewport.w) - 1.0;
    };
    box.lower = glm::max(box.lower, toNdc({r.x, r.y}));
    box.upper = glm::min(box.upper, toNdc({r.x + r.width, r.y + r.height}));
    planar.lower = glm::max(planar.lower, box.lower), planar.upper = glm::min(planar.upper, box.upper);
  }
  if (!(planar.lower.x < planar.upper.x && planar.lower.y < planar.upper.y)) return std::nullopt;
  return planar;
}

std::vector<CoplanarSurfaces::Piece> CoplanarSurfaces::piecesOf(const PlanarMesh& planar,
                                                                const glm::dmat3& commonFromPlane,
                                                                const Common& common) {
  std::vector<Piece> pieces;
  for (uint32_t t = 0; t < planar.mesh->triangleCount; ++t) {
    Corners at;
    Box2 box;
    for (uint32_t k = 0; k < 3; ++k) {
      at[k] = cornerOf(*planar.mesh, t, k);
      const glm::dvec3 p = commonFromPlane * glm::dvec3(at[k][planar.axes.x], at[k][planar.axes.y], 1);
      box.add(glm::dvec2(p) / p.z);
    }
    if (!box.meets(common.box, glm::min(common.narrow, 0.5 * (box.upper - box.lower)))) continue;
    Piece piece;
    for (size_t k = 0; k < 3; ++k) {
      const glm::dvec4 p = planar.place.clipFromObject * glm::dvec4(at[k], 1);
      piece.at[k] = glm::dvec3(p) / p.w;
      piece.box.add(glm::dvec2(piece.at[k]));
    }
    pieces.push_back(piece);
  }
  return pieces;
}

bool CoplanarSurfaces::overlap(const PlanarMesh& a, const PlanarMesh& b) {
  const glm::dvec2 lower = glm::max(a.lower, b.lower), upper = glm::min(a.upper, b.upper);
  if (!(lower.x + kNarrow < upper.x && lower.y + kNarrow < upper.y)) return false;
  if (a.place.at.framebuffer != b.place.at.framebuffer || a.place.at.viewport != b.place.at.viewport)
    return false;
  if (!(a.place.offset == b.place.offset)) return false;
  // How far rasterisers round: up to eight steps of a 24-bit depth buffer, or four of a coarser one.
  const double most = std::max(0x1p-20, 8.0 * double{a.place.offset.resolution});
  const glm::dvec3 apart = a.plane - b.plane;
  for (const double x : {lower.x, upper.x})
    for (const double y : {lower.y, upper.y})
      if (!(std::abs(apart.x * x + apart.y * y + apart.z) <= most)) return false;
  // The same mesh in the same place: all triangles are equal.
  if (a.mesh->geometryId == b.mesh->geometryId && a.place.clipFromObject == b.place.clipFromObject)
    return false;
  if (!a.before || !b.before) return true;

  const bool same = a.clipFromPlane == b.clipFromPlane && a.axes == b.axes;
  const glm::dmat3 aFromB = same ? glm::dmat3(1) : glm::inverse(a.clipFromPlane) * b.clipFromPlane;
  const Box2 first = boundsOf(*a.mesh, a.axes);
  Box2 second;
  for (const glm::dvec3& corner : cornersOf(boundsOf(*b.mesh, b.axes))) {
    const glm::dvec3 p = aFromB * corner;
    if (!(p.z > 0)) return true;  // rare: different projections
    second.add(glm::dvec2(p) / p.z);
  }
  // Float matrices make touching neighbours overlap by about this much.
  constexpr double kRounding = 1e-5;
  Common common{{glm::max(first.lower, second.lower), glm::min(first.upper, second.upper)}};
  common.narrow = kRounding * glm::min(first.upper - first.lower, second.upper - second.lower);
  if (!first.meets(second, common.narrow)) return false;
  work_ += uint64_t{a.mesh->triangleCount} + b.mesh->triangleCount;
  if (work_ > kMaxWork) return true;
  return anyOverlap(piecesOf(a, glm::dmat3(1), common), piecesOf(b, aFromB, common));
}

/// A vertical line sweeps over both from the left; triangles that it crosses are open.
bool CoplanarSurfaces::anyOverlap(std::vector<Piece> a, std::vector<Piece> b) {
  const auto isBefore = [](const Piece& p, const Piece& q) { return p.box.lower.x < q.box.lower.x; };
  std::sort(a.begin(), a.end(), isBefore), std::sort(b.begin(), b.end(), isBefore);
  std::vector<const Piece*> openA, openB;
  for (size_t i = 0, j = 0; i < a.size() || j < b.size();) {
    const bool first = j == b.size() || (i < a.size() && isBefore(a[i], b[j]));
    const Piece& piece = first ? a[i++] : b[j++];
    std::vector<const Piece*>& others = first ? openB : openA;
    work_ += others.size();
    if (work_ > kMaxWork) return true;
    std::erase_if(others, [&](const Piece* p) { return p->box.upper.x <= piece.box.lower.x + kNarrow; });
    for (const Piece* other : others) {
      if (!piece.box.meets(other->box, glm::dvec2(kNarrow))) continue;
      work_ += 8;  // a pair of triangles costs as much as this many boxes
      if (!isApart(piece.at, other->at) && !isApart(other->at, piece.at) && !isSame(piece.at, other->at))
        return true;
    }
    (first ? openA : openB).push_back(&piece);
  }
  return false;
}

bool CoplanarSurfaces::meets(const scene::MeshPtr& mesh, const SurfacePlace& place) {
  if (mesh->shape != scene::Shape::triangles || mesh->triangleCount == 0 ||
      mesh->triangleCount > kMaxTriangles || !hasRoom())
    return false;
  const std::optional<glm::dvec4>& plane = planeOf(*mesh);
  if (!plane) return false;
  std::optional<PlanarMesh> planar = placed(mesh, place, *plane);
  if (!planar) return false;
  bool met = isRemembered(mesh->geometryId), metNow = false;
  for (const PlanarMesh& other : planar_) {
    // If this epoch already found both to overlap other meshes, comparing them adds nothing.
    if (metNow && isRemembered(other.mesh->geometryId) && metIn_[other.mesh->geometryId] == epoch_) continue;
    if (!depths_.reaches(other.at, place.at) || !overlap(other, *planar)) continue;
    found_ = found_ || !met || !isRemembered(other.mesh->geometryId);
    met = metNow = true;
    remember(other.mesh->geometryId), remember(mesh->geometryId);
  }
  planar->epoch = epoch_;
  planar->at = depths_.stamp(place.at);
  planar_.push_back(std::move(*planar));
  used_ = true;
  return met;
}

void CoplanarSurfaces::clear(const DepthClear& depth) {
  depths_.clear(depth);
  endEpoch();
  std::erase_if(planar_, [&](const PlanarMesh& planar) { return depth.removes(planar.place.at); });
}

void CoplanarSurfaces::clear() {
  endEpoch();
  planar_.clear();
  depths_.forget();
}

void CoplanarSurfaces::endEpoch() {
  if (!std::exchange(used_, false)) return;
  work_ = 0;
  ++epoch_;
}

bool CoplanarSurfaces::hasRoom() {
  if (planar_.size() < kMaxPlanarMeshes) return true;
  std::erase_if(planar_, [&](const PlanarMesh& planar) { return planar.epoch != epoch_; });
  return planar_.size() < kMaxPlanarMeshes;
}

void CoplanarSurfaces::remember(const Hash128& geometry) {
  constexpr size_t kMax = 4096;  // if there are more, most are no longer drawn
  if (metIn_.size() > kMax) metIn_.clear();
  metIn_[geometry] = epoch_;
}

bool CoplanarSurfaces::isRemembered(const Hash128& geometry) {
  constexpr uint64_t kRemembered = 100;  // epochs
  const auto met = metIn_.find(geometry);
  if (met == metIn_.end()) return false;
  if (epoch_ <= met->second + kRemembered) return true;
  metIn_.erase(met);
  return false;
}

const std::optional<glm::dvec4>& CoplanarSurfaces::planeOf(const scene::Mesh& mesh) {
  constexpr size_t kMax = 4096;
  if (planes_.size() > kMax) planes_.clear();
  const auto known = planes_.find(mesh.geometryId);
  if (known != planes_.end()) return known->second;
  return planes_.emplace(mesh.geometryId, planeOfMesh(mesh)).first->second;
}

}  // namespace gluray::gl
