// Comparisons of surfaces with earlier ones of their depth epoch.
#include "gl/history/multipass_surfaces.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <bit>

namespace gluray::gl {

VertexSet::VertexSet(const scene::Mesh& mesh)
    : words_(std::bit_ceil(mesh.vertexCount / 4 + 1)), lower_(mesh.lower), upper_(mesh.upper) {
  for (uint32_t i = 0; i < mesh.vertexCount; ++i) {
    const Place place = placeOf(mesh.position(i));
    words_[place.word] |= place.bits;
  }
}

bool VertexSet::mayHold(const glm::vec3& point) const {
  if (glm::any(glm::lessThan(point, lower_)) || glm::any(glm::greaterThan(point, upper_))) return false;
  const Place place = placeOf(point);
  return (words_[place.word] & place.bits) == place.bits;
}

VertexSet::Place VertexSet::placeOf(const glm::vec3& point) const {
  const glm::vec3 p = point + 0.0f;  // -0 is 0
  const uint64_t hash = hashBytes(glm::value_ptr(p), sizeof p).low;
  return {static_cast<size_t>(hash >> 12) & (words_.size() - 1),
          uint64_t{1} << (hash & 63) | uint64_t{1} << (hash >> 6 & 63)};
}

bool MultipassSurfaces::anyByProgram(uint32_t framebuffer, uint64_t triangles) const {
  const auto [first, last] = surfaces_.equal_range(placeIn(framebuffer));
  return std::any_of(first, last,
                     [&](const auto& one) { return one.second.mesh->triangleCount == triangles; });
}

bool MultipassSurfaces::anyUnder(const glm::dmat4& eyeFromObject) const {
  return !surfaces_.empty() && surfaces_.contains(hashOf(eyeFromObject));
}

bool MultipassSurfaces::liesUpon(const Surface& surface, const glm::dmat4& eyeFromObject,
                                 std::span<const Triangle> triangles) {
  return surface.eyeFromObject == eyeFromObject && holdsSome(*surface.mesh, triangles);
}

bool MultipassSurfaces::holdsSome(const scene::Mesh& mesh, std::span<const Triangle> triangles) {
  const VertexSet& vertices = verticesOf(mesh);
  return std::any_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](const glm::vec3& p) { return vertices.mayHold(p); });
  });
}

MultipassSurfaces::Meeting MultipassSurfaces::meets(const glm::dmat4& eyeFromObject,
                                                    std::span<const Triangle> triangles,
                                                    const DepthPlace& place, bool pushedBack) {
  Meeting meeting = Meeting::none;
  const auto [first, last] = surfaces_.equal_range(hashOf(eyeFromObject));
  for (auto it = first; it != last; ++it) {
    Surface& surface = it->second;
    if (surface.pushedBack && !pushedBack) continue;  // the offset lets the later pass win in any case
    if (!depths_.reaches(surface.at, place) || !liesUpon(surface, eyeFromObject, triangles)) continue;
    remember(surface.mesh->geometryId);
    meeting = meet(surface, meeting);
  }
  return meeting;
}

MultipassSurfaces::Meeting MultipassSurfaces::meet(Surface& surface, Meeting before) {
  surface.met = true;
  return surface.how == How::pending || before == Meeting::pending ? Meeting::pending : Meeting::drawn;
}

MultipassSurfaces::Meeting MultipassSurfaces::meetsProgram(const DepthPlace& place,
                                                           std::span<const Triangle> triangles,
                                                           uint64_t count, const glm::dmat4* clipFromObject,
                                                           bool pushedBack) {
  Meeting meeting = Meeting::none;
  const auto [first, last] = surfaces_.equal_range(placeIn(place.framebuffer));
  for (auto it = first; it != last; ++it) {
    Surface& surface = it->second;
    if (surface.mesh->triangleCount != count || (surface.pushedBack && !pushedBack)) continue;
    if (!depths_.reaches(surface.at, place)) continue;
    if (clipFromObject && !(*clipFromObject == *surface.clipFromObject)) continue;
    if (!holdsSome(*surface.mesh, triangles)) continue;
    remember(surface.mesh->geometryId);
    meeting = meet(surface, meeting);
  }
  return meeting;
}

bool MultipassSurfaces::meetsSampled(const scene::Mesh& mesh, const glm::dmat4& eyeFromObject,
                                     const DepthPlace& place, bool pushedBack) {
  idle_ = 0;
  for (const auto& [name, at] : unsampledFixed_)
    if (depths_.reaches(at, place)) return true;
  return sampled_.any(mesh, eyeFromObject, pushedBack,
                      [&](const DepthStamp& at, std::span<const Triangle> triangles) {
                        return depths_.reaches(at, place) && holdsSome(mesh, triangles);
                      });
}

bool MultipassSurfaces::meetsRasterised(const scene::Mesh& mesh, const glm::dmat4& eyeFromObject,
                                        const DepthPlace& place, bool pushedBack) {
  if (!rasterised_ || !anyUnder(eyeFromObject)) return false;
  const std::vector<Triangle> triangles = sampleTriangles(mesh);
  const auto [first, last] = surfaces_.equal_range(hashOf(eyeFromObject));
  for (auto it = first; it != last; ++it) {
    if (it->second.how != How::rasterised || it->second.pushedBack != pushedBack ||
        !depths_.reaches(it->second.at, place) || !liesUpon(it->second, eyeFromObject, triangles))
      continue;
    remember(it->second.mesh->geometryId);
    remember(mesh.geometryId);
    return true;
  }
  return false;
}

template <class SameMatrix>
bool MultipassSurfaces::meetsTracedUnder(const Hash128& key, const scene::MeshPtr& mesh,
                                         const scene::Snapshot& batch, const DepthPlace& place,
                                         bool leavesDepth, const SameMatrix& sameMatrix) {
  constexpr uint64_t kMaxCompared = 1 << 16;  // surfaces in a depth epoch: a millisecond
  bool found = false;
  const auto [first, last] = surfaces_.equal_range(key);
  for (auto it = first; it != last && compared_ < kMaxCompared; ++it) {
    Surface& surface = it->second;
    ++compared_;
    if (!leavesDepth && surface.mesh->geometryId == mesh->geometryId) continue;
    if (surface.how != How::traced || !coincident_.coincide(*surface.mesh, *mesh) ||
        !(surface.at.place.viewport == place.viewport) || !sameMatrix(surface) ||
        !(surface.snapshot->polygonOffset == batch.polygonOffset) || !depths_.reaches(surface.at, place))
      continue;
    surface.met = found = true;
    remember(surface.mesh->geometryId);
  }
  if (found) remember(mesh->geometryId);
  return found;
}

bool MultipassSurfaces::meetsTraced(const scene::MeshPtr& mesh, const glm::dmat4& eyeFromObject,
                                    const scene::Snapshot& batch, const DepthPlace& place, bool leavesDepth) {
  return meetsTracedUnder(
      hashOf(eyeFromObject), mesh, batch, place, leavesDepth, [&](const Surface& surface) {
        return surface.eyeFromObject == eyeFromObject && surface.snapshot->camera == batch.camera;
      });
}

bool MultipassSurfaces::meetsTracedByProgram(const scene::MeshPtr& mesh, const glm::dmat4& clipFromObject,
                                             const scene::Snapshot& batch, const DepthPlace& place,
                                             bool leavesDepth) {
  return meetsTracedUnder(placeIn(place.framebuffer), mesh, batch, place, leavesDepth,
                          [&](const Surface& surface) {
                            return surface.clipFromObject && *surface.clipFromObject == clipFromObject;
                          });
}

bool MultipassSurfaces::meetsRasterised(const DepthPlace& place, const scene::Mesh& mesh,
                                        const glm::dmat4& clipFromObject, bool pushedBack) {
  const auto unseen = unseen_.empty() ? unseen_.end() : unseen_.find(unseenKey(place));
  if (unseen != unseen_.end() && unseen->second.counts.contains(mesh.triangleCount) &&
      depths_.reaches(unseen->second.at, place))
    return true;
  const auto meets = [&](const Rasterised& r) {
    return r.at.place.framebuffer == place.framebuffer && r.count == mesh.triangleCount &&
           (pushedBack || !r.pushedBack) && (!r.clipFromObject || *r.clipFromObject == clipFromObject) &&
           depths_.reaches(r.at, place) && holdsSome(mesh, r.triangles);
  };
  if (!std::any_of(rasterisedByProgram_.begin(), rasterisedByProgram_.end(), meets)) return false;
  remember(mesh.geometryId);
  return true;
}

const VertexSet& MultipassSurfaces::verticesOf(const scene::Mesh& mesh) {
  constexpr size_t kKept = 64;
  if (vertices_.size() >= kKept && !vertices_.contains(mesh.geometryId)) vertices_.clear();
  std::unique_ptr<VertexSet>& set = vertices_[mesh.geometryId];
  if (!set) set = std::make_unique<VertexSet>(mesh);
  return *set;
}

}  // namespace gluray::gl
