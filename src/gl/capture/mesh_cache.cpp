#include "gl/capture/mesh_cache.h"

namespace gluray::gl {

bool MeshCache::find(const Hash128& content, KnownMesh& result) {
  const std::lock_guard lock(mutex_);
  const auto it = entries_.find(content);
  if (it == entries_.end()) return false;
  it->second.lastUsed = frame_;
  result = it->second.mesh;
  return true;
}

void MeshCache::put(const Hash128& content, const KnownMesh& mesh) {
  const std::lock_guard lock(mutex_);
  entries_[content] = {mesh, frame_};
}

void MeshCache::advance() {
  constexpr uint64_t kFramesKept = 8;
  const std::lock_guard lock(mutex_);
  ++frame_;
  std::erase_if(entries_, [&](const auto& e) { return e.second.lastUsed + kFramesKept < frame_; });
}

size_t MeshCache::size() {
  const std::lock_guard lock(mutex_);
  return entries_.size();
}

}  // namespace gluray::gl
