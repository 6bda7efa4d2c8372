#include "gl/history/multipass_surfaces.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>

namespace gluray::gl {
namespace {

constexpr size_t kMaxKept = 65536;       // surfaces that are kept across frames
constexpr size_t kMaxAtOnce = 1u << 20;  // surfaces kept without a clear or the end of a frame

}  // namespace

Hash128 MultipassSurfaces::placeIn(uint32_t framebuffer) {
  return hashBytes(&framebuffer, sizeof framebuffer);
}

Hash128 MultipassSurfaces::unseenKey(const DepthPlace& place) {
  const glm::ivec4& v = place.viewport;
  const std::array<int64_t, 5> key = {place.framebuffer, v.x, v.y, v.z, v.w};
  return hashBytes(key.data(), sizeof key);
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
    traced_ = traced_ || snapshot;
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
  rasterised_ = traced_ = false, unseenCounts_ = 0;
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
  compared_ = 0;
  ++idle_;
  if (std::exchange(used_, false)) ++epoch_;
}

template <class Gone>
void MultipassSurfaces::forgetIf(const Gone& gone) {
  std::erase_if(surfaces_, [&](const auto& one) { return gone(one.second.at); });
  rasterised_ = rasterised_ && !surfaces_.empty(), traced_ = traced_ && !surfaces_.empty();
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
  scene::Region& all = known->second.place.region;
  all = scene::united(all, place.region);
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
  const scene::Region earlier = unseen.at.place.region;
  unseen.at = depths_.stamp(place);
  unseen.at.place.region = scene::united(earlier, place.region);
  if (unseen.counts.insert(count).second) ++unseenCounts_;
  lastUnseen_ = {place, count};
}

void MultipassSurfaces::remember(const Hash128& geometry) {
  constexpr size_t kMax = 4096;  // if there are more, most are no longer drawn
  if (metIn_.size() > kMax) metIn_.clear();
  metIn_[geometry] = epoch_;
}

bool MultipassSurfaces::several(const Hash128& geometry) {
  if (metIn_.empty()) return false;
  const auto met = metIn_.find(geometry);
  if (met == metIn_.end()) return false;
  if (epoch_ <= met->second + kRemembered) return true;
  metIn_.erase(met);
  return false;
}

}  // namespace gluray::gl
