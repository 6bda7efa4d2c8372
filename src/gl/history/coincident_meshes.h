// Finds meshes that share triangles. Remembers the answers. A part of MultipassSurfaces, GL thread.
#pragma once
#include "base/hash.h"
#include "scene/mesh.h"

#include <unordered_map>

namespace gluray::gl {

class CoincidentMeshes {
 public:
  /// Whether a triangle of a sample (about 32) of one mesh is a triangle of the other, with the same
  /// orientation. Solids that touch have the same triangles only with opposite orientations. The first time
  /// reads all triangles of meshes whose bounds contain sampled triangles, about 5 ns each.
  bool coincide(const scene::Mesh& a, const scene::Mesh& b);

 private:
  std::unordered_map<Hash128, bool> answers_;  // by both geometries
};

}  // namespace gluray::gl
