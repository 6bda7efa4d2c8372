#include "frame/last_pictures.h"

#include <algorithm>
#include <exception>

namespace gluray::frame {
namespace {

constexpr size_t kMostInstances = 2000;  // more are not worth the time to compare and copy

bool isSameLayers(const std::shared_ptr<const scene::Layers>& a,
                  const std::shared_ptr<const scene::Layers>& b) {
  return a == b || (a && b && *a == *b);
}

}  // namespace

/// Compares the most changeable state first. Allocates nothing.
bool LastPictures::isSame(Entry& entry, const scene::Snapshot& s) noexcept {
  const scene::Snapshot& e = entry.shows;
  if (!entry.whole || e.eyeFromWorld != s.eyeFromWorld || !(e.camera == s.camera) ||
      !(e.region == s.region) || e.instances.size() != s.instances.size())
    return false;
  for (size_t i = 0; i < s.instances.size(); ++i) {
    scene::Instance& one = entry.shows.instances[i];
    one.mesh = entry.meshes[i].lock();
    const bool same = one.mesh && one == s.instances[i];
    one.mesh.reset();
    if (!same) return false;
  }
  return e.samples == s.samples && e.samplePositions == s.samplePositions &&
         e.polygonOffset == s.polygonOffset && e.wideColors == s.wideColors && e.laterWins == s.laterWins &&
         e.shadings == s.shadings && e.settings == s.settings && isSameLayers(e.layers, s.layers);
}

LastPictures::Picture* LastPictures::of(const scene::Snapshot& snapshot,
                                        std::optional<uint32_t> missColor) noexcept {
  for (Entry& entry : entries_) {
    if (missColor && entry.picture.image.missColor != *missColor) continue;
    if (!isSame(entry, snapshot)) continue;
    entry.used = ++uses_;
    return &entry.picture;
  }
  return nullptr;
}

void LastPictures::forgetPasses(uint64_t view) noexcept {
  for (Entry& entry : entries_)
    if (view == 0 || entry.shows.view == view) entry.picture.refinement.reset();
}

size_t LastPictures::bytes() const noexcept {
  size_t bytes = 0;
  for (const Entry& entry : entries_) bytes += entry.picture.image.bytes();
  return bytes;
}

void LastPictures::keepWithinBudget() noexcept {
  if (bytes() <= kBudget) return;
  for (Entry& entry : entries_)
    if (&entry != next_) entry = {};
}

LastPictures::Picture& LastPictures::next() noexcept {
  keepWithinBudget();
  const bool one = next_ && next_->picture.image.bytes() > kBudget / 2;
  if (!one)
    next_ = &*std::min_element(entries_.begin(), entries_.end(),
                               [](const Entry& a, const Entry& b) { return a.used < b.used; });
  next_->whole = false;
  next_->shows = {};
  next_->meshes.clear();
  next_->used = ++uses_;
  next_->picture.id = ++ids_;
  next_->picture.refinement.reset();
  next_->picture.refined = false;
  return next_->picture;
}

void LastPictures::keep(const scene::Snapshot& snapshot) noexcept {
  if (snapshot.instances.size() > kMostInstances) return;
  try {
    next_->shows = snapshot;
    for (scene::Instance& instance : next_->shows.instances) {
      next_->meshes.push_back(instance.mesh);
      instance.mesh.reset();
    }
    next_->whole = true;
  } catch (const std::exception&) { next_->shows = {}; }  // out of memory: trace it again next time
}

}  // namespace gluray::frame
