// How large the triangles of meshes are. Owned by World. Any thread.
#pragma once
#include "base/hash.h"
#include "scene/mesh.h"

#include <mutex>
#include <unordered_map>

namespace gluray::accel {

class TriangleSizes {
 public:
  /// The longest edge of all triangles, object space; 0 of other shapes. Looks at a mesh once.
  float longestEdge(const scene::Mesh& mesh);

 private:
  std::mutex mutex_;
  std::unordered_map<Hash128, float> longest_;  // by geometry
};

}  // namespace gluray::accel
