// Tests whether matrices are affine or invertible, and transforms bounds of meshes. Any thread.
#pragma once
#include "scene/box_corner.h"
#include "scene/mesh.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace gluray::gl {

/// Whether all points within `reach` of the origin (per axis) get the same w, up to single-precision
/// rounding.
inline bool isAffine(const glm::dmat4& m, const glm::dvec3& reach) {
  constexpr double kRounding = 2e-6;  // a thousandth of a pixel in a window of a thousand pixels
  double change = 0;
  for (int c = 0; c < 3; ++c) change += std::abs(m[c][3]) * reach[c];
  return m[3][3] > 0 && change <= kRounding * m[3][3];
}

/// Whether the matrix and its inverse are finite: rays are transformed by both.
inline bool isInvertible(const glm::dmat4& m) {
  const glm::dmat4 inverse = glm::inverse(m);
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r)
      if (!std::isfinite(m[c][r]) || !std::isfinite(inverse[c][r])) return false;
  return true;
}

/// The mesh's largest distance from the origin along each axis.
inline glm::dvec3 reachOf(const scene::Mesh& mesh) {
  return glm::max(glm::abs(glm::dvec3(mesh.lower)), glm::abs(glm::dvec3(mesh.upper)));
}

/// The eight corners of the mesh's bounds, in clip space.
inline std::array<glm::dvec4, 8> boundsInClip(const scene::Mesh& mesh, const glm::dmat4& clipFromObject) {
  std::array<glm::dvec4, 8> corners;
  for (int i = 0; i < 8; ++i)
    corners[static_cast<size_t>(i)] =
        clipFromObject * glm::dvec4(scene::boxCorner(mesh.lower, mesh.upper, i), 1);
  return corners;
}

/// How far apart the mesh's points are in depth, NDC; infinite if they are not all before the viewer.
inline double depthExtent(const scene::Mesh& mesh, const glm::dmat4& clipFromObject) {
  double lower = INFINITY, upper = -INFINITY;
  for (const glm::dvec4& clip : boundsInClip(mesh, clipFromObject)) {
    if (!(clip.w > 0)) return INFINITY;
    lower = std::min(lower, clip.z / clip.w), upper = std::max(upper, clip.z / clip.w);
  }
  return upper - lower;
}

/// Whether all points of the mesh have the same window depth: then drawing order, not distance, decides.
inline bool isFlat(const scene::Mesh& mesh, const glm::dmat4& clipFromObject) {
  double lower = INFINITY, upper = -INFINITY;
  for (const glm::dvec4& clip : boundsInClip(mesh, clipFromObject)) {
    const double depth = clip.z / clip.w;
    lower = std::min(lower, depth), upper = std::max(upper, depth);
  }
  constexpr double kDepthStep = 1.0 / (1 << 23);  // in NDC: slightly more than one 24-bit step
  return !(upper - lower > kDepthStep);
}

}  // namespace gluray::gl
