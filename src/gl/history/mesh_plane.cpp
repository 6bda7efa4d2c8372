#include "gl/history/mesh_plane.h"

#include <cmath>

namespace gluray::gl {

glm::dvec3 cornerOf(const scene::Mesh& mesh, uint32_t triangle, uint32_t k) {
  return glm::dvec3(mesh.position(mesh.corner(triangle, k)));
}

std::optional<glm::dvec4> planeOfMesh(const scene::Mesh& mesh) {
  glm::dvec3 normal(0);
  for (uint32_t t = 0; t < mesh.triangleCount && normal == glm::dvec3(0); ++t) {
    const glm::dvec3 p = cornerOf(mesh, t, 0);
    normal = glm::cross(cornerOf(mesh, t, 1) - p, cornerOf(mesh, t, 2) - p);
  }
  if (!(glm::length(normal) > 0)) return std::nullopt;
  normal = glm::normalize(normal);
  const glm::dvec3 origin = cornerOf(mesh, 0, 0);
  const glm::dvec3 reach = glm::max(glm::abs(glm::dvec3(mesh.lower)), glm::abs(glm::dvec3(mesh.upper)));
  const double rounding = 1e-6 * (reach.x + reach.y + reach.z);
  for (uint32_t t = 0; t < mesh.triangleCount; ++t)
    for (uint32_t k = 0; k < 3; ++k)
      if (!(std::abs(glm::dot(normal, cornerOf(mesh, t, k) - origin)) <= rounding)) return std::nullopt;
  return glm::dvec4(normal, -glm::dot(normal, origin));
}

glm::ivec2 axesOfPlane(const glm::dvec4& plane) {
  const glm::dvec3 n = glm::abs(glm::dvec3(plane));
  if (n.x >= n.y && n.x >= n.z) return {1, 2};
  return n.y >= n.z ? glm::ivec2(0, 2) : glm::ivec2(0, 1);
}

glm::dmat3 clipFromPlane(const glm::dmat4& clipFromObject, const glm::dvec4& plane, const glm::ivec2& axes) {
  const int third = 3 - axes.x - axes.y;
  const auto column = [&](int axis) {
    const glm::dvec4 c = clipFromObject[axis] - clipFromObject[third] * (plane[axis] / plane[third]);
    return glm::dvec3(c.x, c.y, c.w);
  };
  return {column(axes.x), column(axes.y), column(3)};
}

}  // namespace gluray::gl
