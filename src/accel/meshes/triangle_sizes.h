// Caches the longest triangle edge of each mesh. Owned by World. Any thread.
#pragma once
#include "base/hash.h"
#include "scene/mesh.h"

#include <mutex>
#include <unordered_map>

namespace gluray::accel {

class TriangleSizes {
 public:
  /// The longest triangle edge, object space; 0 for other shapes. Computed once per mesh.
  float longestEdge(const scene::Mesh& mesh);

 private:
  std::mutex mutex_;
  std::unordered_map<Hash128, float> longest_;  // keyed by geometry id
};

}  // namespace gluray::accel
