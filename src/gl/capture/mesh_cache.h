// Meshes of a share group by content hash, which recognises geometry that is sent again every frame. Any
// thread.
#pragma once
#include "base/hash.h"
#include "scene/mesh.h"

#include <cstdint>
#include <limits>
#include <mutex>
#include <unordered_map>

namespace gluray::gl {

/// A mesh, and what the classifier needs to know of the vertices it was built from.
struct KnownMesh {
  scene::MeshPtr mesh;       // null if it cannot be traced (homogeneous vertices)
  bool homogeneous = false;  // some vertex has w != 1
  float leastSquareOfNormals = std::numeric_limits<float>::infinity();  // as of the function of that name
};

class MeshCache {
 public:
  /// Finds the mesh with this content and marks it as used. False if there is none.
  bool find(const Hash128& content, KnownMesh& result);
  void put(const Hash128& content, const KnownMesh& mesh);
  /// Call when a frame ends: forgets meshes that were not used in the last eight.
  void advance();
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
