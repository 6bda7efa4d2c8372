#include "accel/blas_cache.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace gluray::accel {

BlasCache::BlasCache(const Device& device, size_t idleBudgetBytes)
    : device_(device), idleBudgetBytes_(idleBudgetBytes) {}

std::vector<BlasPtr> BlasCache::get(const std::vector<const scene::Mesh*>& meshes, BvhQuality quality) {
  constexpr uint32_t kSmall = 20000;  // triangles: below it, whole builds in parallel beat parallel builds
  std::vector<BlasPtr> result(meshes.size());
  std::vector<std::pair<Key, BlasPtr>> small, large;
  std::unordered_map<Key, BlasPtr, KeyHash> coming;
  for (size_t i = 0; i < meshes.size(); ++i) {
    if (meshes[i]->triangleCount == 0) continue;
    const Key key{meshes[i]->geometryId, quality};
    if (const auto known = blases_.find(key); known != blases_.end()) {
      result[i] = known->second;
    } else {
      BlasPtr& blas = coming[key];
      if (!blas) {
        blas = std::make_shared<Blas>(device_, iota_, *meshes[i], quality);
        (meshes[i]->triangleCount < kSmall ? small : large).emplace_back(key, blas);
      }
      result[i] = blas;
    }
    result[i]->lastUsed = clock_;
  }

  const auto keep = [&](const std::pair<Key, BlasPtr>& built) {
    blases_.insert(built);
    ++builds_;
  };
  for (const auto& entry : large) {
    entry.second->build();
    keep(entry);
  }
  if (small.size() == 1)
    small[0].second->build();
  else
    tbb::parallel_for(size_t{0}, small.size(), [&](size_t i) { small[i].second->build(); });
  std::for_each(small.begin(), small.end(), keep);
  return result;
}

bool BlasCache::evictDownTo(size_t bytes) {
  std::vector<std::pair<uint64_t, Key>> idle;
  size_t idleBytes = 0;
  for (const auto& [key, blas] : blases_) {
    if (blas->lastUsed == clock_) continue;
    idle.emplace_back(blas->lastUsed, key);
    idleBytes += blas->bvhBytes() + blas->pinnedBytes();
  }
  if (idleBytes <= bytes) return false;
  std::sort(idle.begin(), idle.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [lastUsed, key] : idle) {
    if (idleBytes <= bytes) break;
    const auto entry = blases_.find(key);
    idleBytes -= entry->second->bvhBytes() + entry->second->pinnedBytes();
    blases_.erase(entry);
  }
  return true;
}

}  // namespace gluray::accel
