// Meshes known by content, so that geometry sent again every frame is recognised. Any thread.
#pragma once
#include "base/hash.h"
#include "scene/mesh.h"

#include <cstdint>
#include <mutex>
#include <unordered_map>

namespace gluray::gl {

/// A mesh and what the triage asks about the vertices it came from.
struct KnownMesh {
  scene::MeshPtr mesh;       // null where nothing can be traced (homogeneous vertices)
  bool homogeneous = false;  // some vertex has w != 1
};

class MeshCache {
 public:
  /// The mesh with this content, or null mesh. Marks it as used in `frame`.
  bool find(const Hash128& content, uint64_t frame, KnownMesh& result);
  void put(const Hash128& content, uint64_t frame, const KnownMesh& mesh);
  /// Forgets what was not used in the last frames.
  void expire(uint64_t frame);

 private:
  struct Entry {
    KnownMesh mesh;
    uint64_t lastUsed = 0;
  };
  std::mutex mutex_;
  std::unordered_map<Hash128, Entry> entries_;
};

}  // namespace gluray::gl
