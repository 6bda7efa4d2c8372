#include "frame/images/image_cache.h"

#include "scene/backdrop.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace gluray::frame {
namespace {

constexpr size_t kMaxInstances = 2000;  // more are not worth the time to compare and copy

bool isSameLayers(const std::shared_ptr<const scene::Layers>& a,
                  const std::shared_ptr<const scene::Layers>& b) {
  return a == b || (a && b && *a == *b);
}

/// Layers that are blended in the order of drawing keep the channels that are not written.
bool isSameWrites(const scene::Snapshot& a, const scene::Snapshot& b) {
  const bool blended = b.layers && b.layers->of == scene::Layers::Of::drawn;
  return !blended || a.colorWrites == b.colorWrites;
}

bool isSameBackdrop(const std::shared_ptr<const scene::Backdrop>& a,
                    const std::shared_ptr<const scene::Backdrop>& b) {
  return a == b || (a && b && *a == *b);
}

}  // namespace

/// `meshes`: those of the kept instances, which hold none.
bool ImageCache::areSame(std::vector<scene::Instance>& kept, const std::weak_ptr<const scene::Mesh>* meshes,
                         const std::vector<scene::Instance>& now) noexcept {
  if (kept.size() != now.size()) return false;
  for (size_t i = 0; i < now.size(); ++i) {
    scene::Instance& one = kept[i];
    one.mesh = meshes[i].lock();
    const bool same = one.mesh && one == now[i];
    one.mesh.reset();
    if (!same) return false;
  }
  return true;
}

/// Compares the most changeable state first. Allocates nothing.
bool ImageCache::isSame(Entry& entry, const scene::Snapshot& s) noexcept {
  const scene::Snapshot& e = entry.shows;
  if (!entry.whole || e.eyeFromWorld != s.eyeFromWorld || !(e.camera == s.camera) ||
      !(e.region == s.region) || !areSame(entry.shows.instances, entry.meshes.data(), s.instances))
    return false;
  if (!entry.around != !s.secondaryScene) return false;
  if (entry.around && !(entry.around->shadings == s.secondaryScene->shadings &&
                        entry.around->blended == s.secondaryScene->blended &&
                        entry.around->viewFromWorld == s.secondaryScene->viewFromWorld &&
                        entry.around->volumes == s.secondaryScene->volumes &&
                        scene::haveSameCaptures(*entry.around, *s.secondaryScene) &&
                        areSame(entry.around->instances, entry.meshes.data() + s.instances.size(),
                                s.secondaryScene->instances)))
    return false;
  return e.extent == s.extent && e.samples == s.samples && e.samplePositions == s.samplePositions &&
         e.polygonOffset == s.polygonOffset && e.wideColors == s.wideColors &&
         e.byteSamples == s.byteSamples && e.limitedSamples == s.limitedSamples &&
         e.laterWins == s.laterWins && e.depthSteps == s.depthSteps && e.shadings == s.shadings &&
         e.settings == s.settings && e.ground == s.ground && e.catches == s.catches &&
         isSameLayers(e.layers, s.layers) && isSameWrites(e, s) && isSameBackdrop(e.backdrop, s.backdrop);
}

ImageCache::CachedImage* ImageCache::findImage(const scene::Snapshot& snapshot,
                                               std::optional<uint32_t> missColor, Of which) noexcept {
  for (Entry& entry : entries_) {
    if (which == Of::thisSnapshot && entry.shows.number != snapshot.number) continue;
    if (missColor && entry.cached.image.missColor != *missColor) continue;
    if (!isSame(entry, snapshot)) continue;
    entry.used = ++uses_;
    return &entry.cached;
  }
  return nullptr;
}

void ImageCache::forgetPasses(uint64_t view) noexcept {
  for (Entry& entry : entries_)
    if (view == 0 || entry.shows.view == view) entry.cached.refinement.reset();
}

size_t ImageCache::bytes() const noexcept {
  size_t bytes = 0;
  for (const Entry& entry : entries_) bytes += entry.cached.image.bytes();
  return bytes;
}

void ImageCache::keepWithinBudget() noexcept {
  if (bytes() <= kBudget) return;
  for (Entry& entry : entries_)
    if (&entry != next_) entry = {};
}

ImageCache::CachedImage& ImageCache::makeRoom() noexcept {
  keepWithinBudget();
  const bool one = next_ && next_->cached.image.bytes() > kBudget / 2;
  if (!one)
    next_ = &*std::min_element(entries_.begin(), entries_.end(),
                               [](const Entry& a, const Entry& b) { return a.used < b.used; });
  next_->whole = false;
  next_->shows = {};
  next_->around.reset();
  next_->meshes.clear();
  next_->used = ++uses_;
  next_->cached.id = ++ids_;
  next_->cached.refinement.reset();
  next_->cached.refined = false;
  return next_->cached;
}

void ImageCache::keep(const scene::Snapshot& snapshot) noexcept {
  if (scene::countAll(snapshot) > kMaxInstances) return;
  const auto takeMeshes = [this](std::vector<scene::Instance>& instances) {
    for (scene::Instance& instance : instances)
      next_->meshes.push_back(std::exchange(instance.mesh, nullptr));
  };
  try {
    next_->shows = snapshot;
    takeMeshes(next_->shows.instances);
    if (snapshot.secondaryScene) {
      next_->shows.secondaryScene.reset();
      next_->around = std::make_shared<scene::SecondaryScene>(*snapshot.secondaryScene);
      takeMeshes(next_->around->instances);
    }
    next_->whole = true;
  } catch (const std::exception&) {
    next_->shows = {}, next_->around.reset();
  }  // out of memory: trace it again next time
}

}  // namespace gluray::frame
