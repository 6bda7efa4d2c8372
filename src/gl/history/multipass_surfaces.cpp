#include "gl/history/multipass_surfaces.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <bit>
#include <utility>

namespace gluray::gl {
namespace {

/// Key in surfaces_ of surfaces that shader programs draw into a framebuffer.
Hash128 placeIn(uint32_t framebuffer) { return hashBytes(&framebuffer, sizeof framebuffer); }

/// Key in unseen_.
Hash128 unseenKey(const DepthPlace& place) {
  static_assert(sizeof place == sizeof place.framebuffer + sizeof place.viewport);
  return hashBytes(&place, sizeof place);
}

/// The smallest viewport that contains both.
glm::ivec4 uniteViewports(const glm::ivec4& a, const glm::ivec4& b) {
  const glm::ivec2 lower = glm::min(glm::ivec2(a), glm::ivec2(b));
  const glm::ivec2 upper = glm::max(glm::ivec2(a.x + a.z, a.y + a.w), glm::ivec2(b.x + b.z, b.y + b.w));
  return glm::ivec4(lower, upper - lower);
}

constexpr size_t kMaxKept = 65536;       // surfaces that are kept across frames
constexpr size_t kMaxAtOnce = 1u << 20;  // surfaces kept without a clear or the end of a frame

}  // namespace

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

void MultipassSurfaces::drawn(const scene::MeshPtr& mesh, const glm::dmat4& eyeFromObject, How how,
                              const DepthPlace& place, bool pushedBack) {
  limit();
  surfaces_.emplace(hashOf(eyeFromObject),
                    Surface{mesh, eyeFromObject, how, pushedBack, depths_.stamp(place)});
  rasterised_ = rasterised_ || how == How::rasterised;
  used_ = true;
}

void MultipassSurfaces::drawnByProgram(const scene::MeshPtr& mesh, const glm::dmat4& eyeFromObject,
                                       const glm::dmat4& clipFromObject, const DepthPlace& place,
                                       bool pushedBack) {
  limit();
  Surface surface{mesh, eyeFromObject, How::pending, pushedBack, depths_.stamp(place)};
  surface.clipFromObject = clipFromObject;
  surfaces_.emplace(placeIn(place.framebuffer), std::move(surface));
  used_ = true;
}

void MultipassSurfaces::flushed(const scene::SnapshotPtr& snapshot) {
  for (auto& [place, surface] : surfaces_) {
    if (surface.how != How::pending) continue;
    surface.how = snapshot ? How::traced : How::rasterised;
    surface.snapshot = snapshot;
    rasterised_ = rasterised_ || !snapshot;
  }
}

std::vector<DepthRedraw> MultipassSurfaces::takeTraced() {
  std::vector<DepthRedraw> all;
  for (auto& place : surfaces_) {
    Surface& surface = place.second;
    if (!std::exchange(surface.met, false) || surface.how != How::traced) continue;
    auto alone = std::make_shared<scene::Snapshot>(*surface.snapshot);
    std::erase_if(alone->instances, [&](const scene::Instance& instance) {
      return instance.mesh->geometryId != surface.mesh->geometryId ||
             !(instance.eyeFromObject == surface.eyeFromObject);
    });
    surface.how = How::rasterised, rasterised_ = true;
    surface.snapshot = nullptr;
    if (!alone->instances.empty()) all.push_back({std::move(alone), surface.mesh, surface.clipFromObject});
  }
  return all;
}

void MultipassSurfaces::clear(const DepthClear& depth) {
  depths_.clear(depth);
  endEpoch();
  forgetIf([&](const DepthStamp& at) { return depth.removes(at.place) || depths_.isOld(at); });
}

void MultipassSurfaces::clear() {
  endEpoch();
  surfaces_.clear(), sampled_.clear(), unsampledFixed_.clear(), rasterisedByProgram_.clear(), unseen_.clear();
  rasterised_ = false, unseenCounts_ = 0;
  depths_.forget();
}

void MultipassSurfaces::shown() {
  depths_.nextTurn();
  endEpoch();
  forgetIf([&](const DepthStamp& at) { return depths_.isOld(at); });
  forgetMany();
}

void MultipassSurfaces::endEpoch() {
  lastUnseen_ = {};
  ++idle_;
  if (std::exchange(used_, false)) ++epoch_;
}

template <class Gone>
void MultipassSurfaces::forgetIf(const Gone& gone) {
  std::erase_if(surfaces_, [&](const auto& one) { return gone(one.second.at); });
  rasterised_ = rasterised_ && !surfaces_.empty();
  std::erase_if(rasterisedByProgram_, [&](const Rasterised& r) { return gone(r.at); });
  std::erase_if(unseen_, [&](const auto& one) { return gone(one.second.at); });
  std::erase_if(unsampledFixed_, [&](const auto& one) { return gone(one.second); });
  sampled_.eraseIf(gone);
  if (unseen_.empty()) unseenCounts_ = 0;
}

void MultipassSurfaces::forgetMany() {
  if (surfaces_.size() + sampled_.size() + unseenCounts_ > kMaxKept) clear();
}

/// Bounds memory for programs that neither clear depth nor end frames.
void MultipassSurfaces::limit() {
  if (surfaces_.size() + sampled_.size() + unseenCounts_ + unsampledFixed_.size() >= kMaxAtOnce) clear();
}

void MultipassSurfaces::rasterisedFixed(const glm::dmat4& eyeFromObject, std::vector<Triangle> triangles,
                                        const DepthPlace& place, bool pushedBack) {
  limit();
  sampled_.add(eyeFromObject, std::move(triangles), depths_.stamp(place), pushedBack);
}

void MultipassSurfaces::addUnsampledFixedDraw(const DepthPlace& place) {
  const DepthStamp now = depths_.stamp(place);
  const auto [known, added] = unsampledFixed_.try_emplace(place.framebuffer, now);
  if (added) return;
  known->second.turn = now.turn;
  known->second.place.viewport = uniteViewports(known->second.place.viewport, place.viewport);
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
                                                    std::span<const Triangle> triangles, uint32_t framebuffer,
                                                    bool pushedBack) {
  Meeting meeting = Meeting::none;
  const auto [first, last] = surfaces_.equal_range(hashOf(eyeFromObject));
  for (auto it = first; it != last; ++it) {
    Surface& surface = it->second;
    if (surface.pushedBack && !pushedBack) continue;  // the offset lets the later pass win in any case
    if (!depths_.reaches(surface.at, framebuffer) || !liesUpon(surface, eyeFromObject, triangles)) continue;
    remember(surface.mesh->geometryId);
    meeting = meet(surface, meeting);
  }
  return meeting;
}

MultipassSurfaces::Meeting MultipassSurfaces::meet(Surface& surface, Meeting before) {
  surface.met = true;
  return surface.how == How::pending || before == Meeting::pending ? Meeting::pending : Meeting::drawn;
}

MultipassSurfaces::Meeting MultipassSurfaces::meetsProgram(uint32_t framebuffer,
                                                           std::span<const Triangle> triangles,
                                                           uint64_t count, const glm::dmat4* clipFromObject,
                                                           bool pushedBack) {
  Meeting meeting = Meeting::none;
  const auto [first, last] = surfaces_.equal_range(placeIn(framebuffer));
  for (auto it = first; it != last; ++it) {
    Surface& surface = it->second;
    if (surface.mesh->triangleCount != count || (surface.pushedBack && !pushedBack)) continue;
    if (clipFromObject && !(*clipFromObject == *surface.clipFromObject)) continue;
    if (!holdsSome(*surface.mesh, triangles)) continue;
    remember(surface.mesh->geometryId);
    meeting = meet(surface, meeting);
  }
  return meeting;
}

bool MultipassSurfaces::meetsSampled(const scene::Mesh& mesh, const glm::dmat4& eyeFromObject,
                                     uint32_t framebuffer, bool pushedBack) {
  idle_ = 0;
  for (const auto& [name, at] : unsampledFixed_)
    if (depths_.reaches(at, framebuffer)) return true;
  return sampled_.any(mesh, eyeFromObject, pushedBack,
                      [&](const DepthStamp& at, std::span<const Triangle> triangles) {
                        return depths_.reaches(at, framebuffer) && holdsSome(mesh, triangles);
                      });
}

bool MultipassSurfaces::meetsRasterised(const scene::Mesh& mesh, const glm::dmat4& eyeFromObject,
                                        uint32_t framebuffer, bool pushedBack) {
  if (!rasterised_ || !anyUnder(eyeFromObject)) return false;
  const std::vector<Triangle> triangles = sampleTriangles(mesh);
  const auto [first, last] = surfaces_.equal_range(hashOf(eyeFromObject));
  for (auto it = first; it != last; ++it) {
    if (it->second.how != How::rasterised || it->second.pushedBack != pushedBack ||
        !depths_.reaches(it->second.at, framebuffer) || !liesUpon(it->second, eyeFromObject, triangles))
      continue;
    remember(it->second.mesh->geometryId);
    remember(mesh.geometryId);
    return true;
  }
  return false;
}

void MultipassSurfaces::remember(const Hash128& geometry) {
  constexpr size_t kMax = 4096;  // if there are more, most are no longer drawn
  if (metIn_.size() > kMax) metIn_.clear();
  metIn_[geometry] = epoch_;
}

void MultipassSurfaces::rasterisedByProgram(const DepthPlace& place, uint64_t count,
                                            std::vector<Triangle> triangles, const glm::dmat4* clipFromObject,
                                            bool pushedBack) {
  if (rasterisedByProgram_.size() >= kMaxRasterised || triangles.empty()) return;
  Rasterised r{depths_.stamp(place), count, std::move(triangles), {}, pushedBack};
  if (clipFromObject) r.clipFromObject = *clipFromObject;
  rasterisedByProgram_.push_back(std::move(r));
}

void MultipassSurfaces::rasterisedUnseen(const DepthPlace& place, uint64_t count) {
  if (count == 0 || lastUnseen_ == Unseen{place, count}) return;
  limit();
  UnseenAt& unseen = unseen_[unseenKey(place)];
  unseen.at = depths_.stamp(place);
  if (unseen.counts.insert(count).second) ++unseenCounts_;
  lastUnseen_ = {place, count};
}

bool MultipassSurfaces::meetsRasterised(const DepthPlace& place, const scene::Mesh& mesh,
                                        const glm::dmat4& clipFromObject, bool pushedBack) {
  const auto unseen = unseen_.empty() ? unseen_.end() : unseen_.find(unseenKey(place));
  if (unseen != unseen_.end() && unseen->second.counts.contains(mesh.triangleCount)) return true;
  const auto meets = [&](const Rasterised& r) {
    return r.at.place.framebuffer == place.framebuffer && r.count == mesh.triangleCount &&
           (pushedBack || !r.pushedBack) && (!r.clipFromObject || *r.clipFromObject == clipFromObject) &&
           holdsSome(mesh, r.triangles);
  };
  if (!std::any_of(rasterisedByProgram_.begin(), rasterisedByProgram_.end(), meets)) return false;
  remember(mesh.geometryId);
  return true;
}

bool MultipassSurfaces::several(const Hash128& geometry) {
  if (metIn_.empty()) return false;
  const auto met = metIn_.find(geometry);
  if (met == metIn_.end()) return false;
  if (epoch_ <= met->second + kRemembered) return true;
  metIn_.erase(met);
  return false;
}

const VertexSet& MultipassSurfaces::verticesOf(const scene::Mesh& mesh) {
  constexpr size_t kKept = 64;
  if (vertices_.size() >= kKept && !vertices_.contains(mesh.geometryId)) vertices_.clear();
  std::unique_ptr<VertexSet>& set = vertices_[mesh.geometryId];
  if (!set) set = std::make_unique<VertexSet>(mesh);
  return *set;
}

}  // namespace gluray::gl
