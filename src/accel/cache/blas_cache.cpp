#include "accel/cache/blas_cache.h"

#include "accel/blocks/triangle_blocks.h"
#include "accel/memory/huge_pages.h"
#include "accel/pages/page_structure.h"
#include "parallel/arena.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>
#include <tuple>
#include <unordered_set>
#include <utility>

namespace gluray::accel {
namespace {
constexpr uint32_t kAlone = 20000;     // triangles from which a build alone uses all threads
constexpr uint64_t kRecent = 16;       // batches after a use within which another use is expected,
constexpr uint64_t kLongFrame = 1024;  // or this many, if the use was in this frame or the one before

size_t sizeOf(const BlasPtr& blas) { return blas->bvhBytes() + blas->pinnedBytes(); }

}  // namespace

BlasCache::BlasCache(const Device& device, PageCache& pages, size_t idleBudgetBytes, FreeMemory freeMemory)
    : device_(device), pages_(pages), idleBudgetBytes_(idleBudgetBytes), freeMemory_(freeMemory) {}

void BlasCache::beginBatch(uint64_t frame) {
  constexpr uint64_t kGone = 16;  // batches without use after which a refinement is cancelled
  ++clock_;
  if (frame != frame_) frame_ = frame, ++frames_;
  if (!refinement_.busy()) return;
  const auto found = entries_.find(refining_);
  if (found == entries_.end() || clock_ - found->second.lastUsed > kGone) refinement_.cancel();
  const BackgroundJob::Outcome outcome = refinement_.poll();
  if (outcome == BackgroundJob::Outcome::none) return;
  const BlasPtr better = std::exchange(refined_, nullptr);
  if (found == entries_.end()) return;
  Entry& entry = found->second;
  if (outcome == BackgroundJob::Outcome::done) {
    entry.blas = better;
    ++refinements_;
  }
  // If it failed, keep the fast structure.
  if (clock_ - entry.lastUsed <= kGone) entry.built = BvhQuality::full;
}

BlasPtr BlasCache::use(Entry& entry, const Geometry& geometry) {
  if (geometry.owner && entry.mesh.expired()) entry.mesh = *geometry.owner;
  if (entry.lastUsed != clock_) ++entry.batches;
  entry.lastUsed = clock_;
  entry.lastFrame = frames_;
  return entry.blas;
}

bool BlasCache::thriftHelps(const std::vector<Geometry>& wanted, BvhQuality quality) const {
  return quality != BvhQuality::least &&
         std::any_of(wanted.begin(), wanted.end(), [&](const Geometry& geometry) {
           return geometry.mesh->shape == scene::Shape::triangles &&
                  thriftyQuality(quality, geometry.mesh->triangleCount) == BvhQuality::least &&
                  !entries_.contains({geometry.id(), quality});
         });
}

std::vector<BlasPtr> BlasCache::get(const std::vector<Geometry>& wanted, BvhQuality quality, bool thrifty) {
  std::vector<BlasPtr> result(wanted.size());
  std::vector<std::pair<Key, Entry>> coming;
  std::unordered_map<Key, BlasPtr, KeyHash> started;
  Waiting waiting;
  for (size_t i = 0; i < wanted.size(); ++i) {
    const scene::Mesh& mesh = *wanted[i].mesh;
    if (mesh.triangleCount == 0) continue;
    const Key key{wanted[i].id(), quality};
    if (const auto known = entries_.find(key); known != entries_.end()) {
      result[i] = use(known->second, wanted[i]);
      if (!mesh.residence && !refinement_.busy() &&
          worthRefining(quality, known->second.built, known->second.batches))
        refine(key, known->second, wanted[i]);
      continue;
    }
    BlasPtr& blas = started[key];
    if (!blas) {
      if (started.size() == 1) waiting = waitingOf(wanted, quality);
      BvhQuality first = thrifty ? thriftyQuality(quality, mesh.triangleCount)
                                 : firstQuality(quality, mesh.triangleCount, waiting, freeMemory_);
      const bool roomy = first == BvhQuality::fast || first == BvhQuality::full;
      if (roomy && !thrifty && !mesh.residence) blas = deformed(wanted[i], wanted, quality);
      if (blas)
        first = BvhQuality::fast;
      else
        blas = made(wanted[i], first);
      const bool returns = std::find(freed_.begin(), freed_.end(), key.geometry) != freed_.end();
      coming.push_back({key, {blas, first, clock_, frames_, 1, returns, false, wanted[i].weakOwner()}});
    }
    result[i] = blas;
  }
  build(coming);
  return result;
}

std::vector<BlasPtr> BlasCache::aside(const std::vector<Geometry>& wanted, BvhQuality quality) {
  std::vector<BlasPtr> result(wanted.size());
  std::vector<std::pair<Key, Entry>> coming;
  std::unordered_map<Key, BlasPtr, KeyHash> started;
  Waiting waiting;
  for (size_t i = 0; i < wanted.size(); ++i) {
    if (wanted[i].mesh->triangleCount == 0) continue;
    const Key key{wanted[i].id(), quality};
    if (const auto known = entries_.find(key); known != entries_.end()) {
      known->second.lastUsed = clock_, known->second.lastFrame = frames_;
      result[i] = known->second.blas;
      continue;
    }
    BlasPtr& blas = started[key];
    if (!blas) {
      if (started.size() == 1) waiting = waitingOf(wanted, quality);
      const BvhQuality first = firstQuality(quality, wanted[i].mesh->triangleCount, waiting, freeMemory_);
      blas = made(wanted[i], first);
      coming.push_back({key, {blas, first, clock_, frames_, 0, false, false, wanted[i].weakOwner()}});
    }
    result[i] = blas;
  }
  build(coming);
  return result;
}

BlasPtr BlasCache::made(const Geometry& geometry, BvhQuality quality) {
  if (geometry.mesh->residence) return createPage(device_, pages_, *geometry.mesh);
  return std::make_shared<Blas>(device_, iota_, geometry, quality);
}

/// The idle structure of the mesh's latest earlier positions; entries_.end(): none.
BlasCache::Entries::iterator BlasCache::formerOf(const scene::Mesh& mesh, const std::vector<Geometry>& wanted,
                                                 BvhQuality quality) {
  constexpr uint64_t kMoving = 4;  // batches: meshes that stayed longer do not deform
  std::vector<Entries::iterator> idle;
  for (auto it = entries_.begin(); it != entries_.end(); ++it) {
    const Entry& entry = it->second;
    if (it->first.quality == quality && entry.lastUsed != clock_ && clock_ - entry.lastUsed <= kRecent &&
        entry.batches <= kMoving && entry.blas->triangleCount() == mesh.triangleCount)
      idle.push_back(it);
  }
  std::sort(idle.begin(), idle.end(),
            [](const auto& a, const auto& b) { return a->second.lastUsed > b->second.lastUsed; });
  const auto fits = [&](const Entries::iterator& it) {
    const bool comes = std::any_of(wanted.begin(), wanted.end(), [&](const Geometry& g) {
      return g.mesh->geometryId == it->first.geometry;
    });
    return !comes && it->second.blas->hasTopologyOf(mesh);
  };
  const auto found = std::find_if(idle.begin(), idle.end(), fits);
  return found == idle.end() ? entries_.end() : *found;
}

BlasPtr BlasCache::deformed(const Geometry& geometry, const std::vector<Geometry>& wanted,
                            BvhQuality quality) {
  const scene::Mesh& mesh = *geometry.mesh;
  const bool wantsBest = quality != BvhQuality::automatic && quality != BvhQuality::fast;
  if (wantsBest || mesh.shape != scene::Shape::triangles || mesh.triangleCount < Deformations::kMin)
    return nullptr;
  if (std::find(left_.begin(), left_.end(), mesh.geometryId) != left_.end()) {
    deformations_.comesAround(mesh);
    return nullptr;
  }
  const auto former = formerOf(mesh, wanted, quality);
  if (former == entries_.end()) return nullptr;
  switch (deformations_.stepFor(mesh, former->second.blas->spreadIn(mesh))) {
    case Deformations::Step::build: return nullptr;
    case Deformations::Step::buildToRefit: return Blas::createToRefit(device_, iota_, geometry);
    case Deformations::Step::refit: break;
  }
  const BlasPtr adjusted = Blas::createRefitted(*former->second.blas, mesh);
  left_[refits_++ % left_.size()] = former->first.geometry;
  entries_.erase(former);
  return adjusted;
}

Waiting BlasCache::waitingOf(const std::vector<Geometry>& wanted, BvhQuality quality) const {
  std::unordered_set<Key, KeyHash> counted;
  Waiting waiting;
  for (const Geometry& geometry : wanted) {
    const Key key{geometry.id(), quality};
    if (geometry.mesh->triangleCount == 0 || geometry.mesh->residence || entries_.contains(key) ||
        !counted.insert(key).second)
      continue;
    checkArrays(*geometry.mesh);
    waiting.triangles += geometry.mesh->triangleCount;
    if (TriangleBlocks::likely(*geometry.mesh, TriangleBlocks::Aim::speed))
      waiting.inBlocks += geometry.mesh->triangleCount;
  }
  return waiting;
}

void BlasCache::build(std::vector<std::pair<Key, Entry>>& coming) {
  const SmallPages pages(
      std::accumulate(coming.begin(), coming.end(), uint64_t{0},
                      [](uint64_t sum, const auto& c) { return sum + c.second.blas->triangleCount(); }));
  const auto small = std::stable_partition(
      coming.begin(), coming.end(), [](const auto& c) { return c.second.blas->triangleCount() >= kAlone; });
  const auto keep = [&](const std::pair<Key, Entry>& built) {
    entries_.insert(built);
    ++builds_;
  };
  for (auto large = coming.begin(); large != small; ++large) {
    large->second.blas->build();
    keep(*large);
  }
  if (coming.end() - small == 1)
    small->second.blas->build();
  else
    tbb::parallel_for(small - coming.begin(), coming.end() - coming.begin(),
                      [&](ptrdiff_t i) { coming[static_cast<size_t>(i)].second.blas->build(); });
  std::for_each(small, coming.end(), keep);
}

// Starts the full build of a mesh in use. If that is impossible, the fast structure stays.
void BlasCache::refine(const Key& key, Entry& entry, const Geometry& geometry) {
  entry.built = BvhQuality::full;
  if (!roomToRefine(geometry.mesh->triangleCount, freeMemory_)) return;
  refined_ = std::make_shared<Blas>(device_, iota_, geometry, BvhQuality::full);
  const auto build = [blas = refined_](const std::atomic<bool>& cancelled) {
    Arena alone(1);
    alone.execute([&] { blas->buildBehind(cancelled); });
  };
  if (!refinement_.start(build)) return refined_.reset();
  refining_ = key;
  entry.built = BvhQuality::fast;
}

bool BlasCache::isRecent(const Entry& entry) const {
  const uint64_t batches = clock_ - entry.lastUsed;
  return batches < kRecent || (batches < kLongFrame && frames_ - entry.lastFrame <= 1);
}

// In a frame of several batches (a small view in a corner), each batch leaves the others' large structures
// idle: they must stay while there is memory. Of geometry that is new in every frame, only the last is worth
// keeping.
void BlasCache::evict() {
  if (idleBudgetBytes_ == 0) return void(evictDownTo(0));
  uint64_t latest = 0;
  for (const auto& [key, entry] : entries_)
    if (entry.lastUsed != clock_) latest = std::max(latest, entry.lastUsed);
  size_t recent = 0, needed = 0;
  for (auto& [key, entry] : entries_) {
    const bool recently = entry.lastUsed != clock_ && isRecent(entry);
    entry.needed = recently && (entry.lastUsed == latest || entry.returns);
    if (recently) recent += sizeOf(entry.blas);
    if (entry.needed) needed += sizeOf(entry.blas);
  }
  size_t most = idleBudgetBytes_;
  if (recent > most) {
    const size_t free = freeMemory_();
    most = std::max(most, std::min(recent, free / 4));
    if (needed <= free) most = std::max(most, needed);
  }
  evictDownTo(most);
}

void BlasCache::evictOrphans() {
  std::erase_if(entries_, [](const auto& one) { return one.second.mesh.expired(); });
}

bool BlasCache::evictAllIdle() {
  const bool busy = refinement_.busy();
  refinement_.stop();
  refined_.reset();
  return evictDownTo(0) || busy;
}

bool BlasCache::evictDownTo(size_t bytes) {
  // Geometry that is new in every frame leaves many small structures, which take long to fill the budget.
  constexpr size_t kMaxIdle = 2048;
  std::vector<std::tuple<bool, uint64_t, Key>> idle;  // in eviction order
  size_t idleBytes = 0;
  for (const auto& [key, entry] : entries_) {
    if (entry.lastUsed == clock_) continue;
    idle.emplace_back(entry.needed, entry.lastUsed, key);
    idleBytes += sizeOf(entry.blas);
  }
  const bool tooMany = idle.size() > kMaxIdle;
  const bool all = bytes == 0;  // also those whose memory is counted elsewhere: pages
  if (idle.empty() || (idleBytes <= bytes && !tooMany && !all)) return false;
  std::sort(idle.begin(), idle.end(), [](const auto& a, const auto& b) {
    return std::pair(std::get<0>(a), std::get<1>(a)) < std::pair(std::get<0>(b), std::get<1>(b));
  });
  size_t left = idle.size();
  for (const auto& [needed, lastUsed, key] : idle) {
    if (!all && idleBytes <= bytes && (!tooMany || left <= kMaxIdle / 2)) break;
    --left;
    const auto entry = entries_.find(key);
    idleBytes -= sizeOf(entry->second.blas);
    if (isRecent(entry->second)) freed_[freedCount_++ % freed_.size()] = key.geometry;
    entries_.erase(entry);
  }
  return true;
}

}  // namespace gluray::accel
