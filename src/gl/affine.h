// Matrices of what shader programs draw: whether they keep points finite. Any thread.
#pragma once
#include "scene/mesh.h"

#include <glm/glm.hpp>

#include <cmath>

namespace gluray::gl {

/// Whether the matrix maps points as far as `reach` from the origin along each axis to points whose w is one
/// number, give or take the rounding of floats.
inline bool isAffine(const glm::dmat4& m, const glm::dvec3& reach) {
  constexpr double kRounding = 2e-6;  // a thousandth of a pixel in a window of a thousand
  double change = 0;
  for (int c = 0; c < 3; ++c) change += std::abs(m[c][3]) * reach[c];
  return m[3][3] > 0 && change <= kRounding * m[3][3];
}

/// How far the mesh reaches from the origin along each axis.
inline glm::dvec3 reachOf(const scene::Mesh& mesh) {
  return glm::max(glm::abs(glm::dvec3(mesh.lower)), glm::abs(glm::dvec3(mesh.upper)));
}

/// Whether all of the mesh's bounds have positive w.
inline bool isBeforeViewer(const scene::Mesh& mesh, const glm::dmat4& clipFromObject) {
  for (int corner = 0; corner < 8; ++corner) {
    glm::dvec4 p(mesh.lower, 1);
    for (int c = 0; c < 3; ++c)
      if (corner >> c & 1) p[c] = mesh.upper[c];
    if (!((clipFromObject * p).w > 0)) return false;
  }
  return true;
}

}  // namespace gluray::gl
