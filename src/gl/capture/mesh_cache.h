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
  /// Finds the mesh with this content and marks it as used. False where there is none.
  bool find(const Hash128& content, KnownMesh& result);
  void put(const Hash128& content, const KnownMesh& mesh);
  /// A frame has ended: forgets what was not used in the last ones.
  void advance();
  /// Meshes that are known.
  size_t size();

 private:
  struct Entry {
    KnownMesh mesh;
    uint64_t lastUsed = 0;
  };
  std::mutex mutex_;
  uint64_t frame_ = 0;
  std::unordered_map<Hash128, Entry> entries_;
};

}  // namespace gluray::gl
