#include "gl/mesh_cache.h"

namespace gluray::gl {

bool MeshCache::find(const Hash128& content, uint64_t frame, KnownMesh& result) {
  const std::lock_guard lock(mutex_);
  const auto it = entries_.find(content);
  if (it == entries_.end()) return false;
  it->second.lastUsed = frame;
  result = it->second.mesh;
  return true;
}

void MeshCache::put(const Hash128& content, uint64_t frame, const KnownMesh& mesh) {
  const std::lock_guard lock(mutex_);
  entries_[content] = {mesh, frame};
}

void MeshCache::expire(uint64_t frame) {
  constexpr uint64_t kFramesKept = 8;
  const std::lock_guard lock(mutex_);
  std::erase_if(entries_, [&](const auto& e) { return e.second.lastUsed + kFramesKept < frame; });
}

}  // namespace gluray::gl
