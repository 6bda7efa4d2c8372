// Whether rays see a mesh to a fraction of a pixel. They meet triangles in floats: where a triangle is much
// larger than what is seen of it, the roundings of its corners' distances are as large as pixels. Owned by
// Context, GL thread.
#pragma once
#include "base/hash.h"
#include "scene/mesh.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace gluray::gl {

class RayPrecision {
 public:
  /// Whether rays may see some triangle of `mesh` in another place than OpenGL, by a tenth of a pixel or more
  /// of a viewport of that size. Of a mesh the kMostLooked largest triangles are looked at.
  bool isTooLarge(const scene::Mesh& mesh, const glm::dmat4& clipFromObject, glm::ivec2 viewport);

  static constexpr size_t kMostLooked = 64;

 private:
  struct Large {
    uint32_t triangle;
    double size;  // longest edge
  };
  const std::vector<Large>& largestOf(const scene::Mesh& mesh);
  std::unordered_map<Hash128, std::vector<Large>> largest_;  // by geometry, the largest first
};

}  // namespace gluray::gl
