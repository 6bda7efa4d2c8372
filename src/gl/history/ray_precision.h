// Whether rays hit a mesh with sub-pixel accuracy. Ray-triangle tests use single precision: if a triangle is
// much larger than its visible part, the rounding errors of its corners amount to pixels. Owned by Context,
// GL thread.
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
  /// Whether rays may see some triangle of `mesh` a tenth of a pixel or more away from where OpenGL draws it,
  /// in a viewport of that size, or miss it because it exceeds the range of floats. Checks the kMaxExamined
  /// largest triangles.
  bool isTooLarge(const scene::Mesh& mesh, const glm::dmat4& clipFromObject, glm::ivec2 viewport);

  /// Whether the mesh is so far from the origin of its space that single-precision rounding moves it by a
  /// tenth of a pixel or more: OpenGL's transformation of its vertices and the ray tests round differently.
  /// `objectFromMesh` places the mesh (an instance); `clipFromObject` is the matrix that the program applies
  /// to the placed vertices.
  static bool isFarFromOrigin(const scene::Mesh& mesh, const glm::dmat4& clipFromObject, glm::ivec2 viewport,
                              const glm::dmat4& objectFromMesh = glm::dmat4(1));

  /// The longest edge of the mesh's triangles, of which there must be one.
  double longestEdge(const scene::Mesh& mesh) { return largestOf(mesh).front().size; }

  static constexpr size_t kMaxExamined = 64;

 private:
  struct Large {
    uint32_t triangle;
    double size;  // longest edge
  };
  const std::vector<Large>& largestOf(const scene::Mesh& mesh);
  std::unordered_map<Hash128, std::vector<Large>> largest_;  // by geometry, largest first
};

}  // namespace gluray::gl
