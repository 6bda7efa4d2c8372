#include "scene/same_camera.h"

#include <algorithm>
#include <cmath>

namespace gluray::scene {
namespace {

/// Matrices of programs are floats, and the far plane may be thousands of times as far as the near plane.
constexpr double kRounding = 1e-3;

bool isSimilarity(const glm::dmat3& m) {
  const glm::dmat3 squared = glm::transpose(m) * m;
  const double size = squared[0][0];
  if (!(size > 0) || !std::isfinite(size)) return false;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r)
      if (!(std::abs(squared[c][r] / size - (c == r ? 1 : 0)) <= 2 * kRounding)) return false;
  return true;
}

bool isIdentity(const glm::dmat4& m, double distance) {
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 3; ++r)
      if (!(std::abs(m[c][r] - (c == r ? 1 : 0)) <= kRounding * (c == 3 ? distance : 1))) return false;
  return true;
}

}  // namespace

std::optional<glm::dmat4> eyeFromEye(const glm::dmat4& clipFromTo, const glm::dmat4& clipFromFrom,
                                     double distance) {
  if (clipFromTo == clipFromFrom) return glm::dmat4(1);
  glm::dmat4 m = glm::inverse(clipFromTo) * clipFromFrom;
  m /= m[3][3];
  double change = 0;  // of w, within that distance
  for (int c = 0; c < 3; ++c) change += std::abs(m[c][3]) * distance;
  if (!(change <= kRounding) || !isSimilarity(glm::dmat3(m))) return std::nullopt;
  if (isIdentity(m, distance)) return glm::dmat4(1);
  for (int c = 0; c < 4; ++c) m[c][3] = c == 3 ? 1 : 0;
  return m;
}

std::optional<glm::dmat4> eyeFromEye(const CameraMatrices& to, const CameraMatrices& from) {
  const double distance =
      std::max(glm::length(glm::dvec3(to.eyeFromWorld[3])), glm::length(glm::dvec3(from.eyeFromWorld[3])));
  return eyeFromEye(to.clipFromEye, from.clipFromEye, distance);
}

std::optional<glm::dmat4> eyeFromEye(const Snapshot& to, const Snapshot& from) {
  return eyeFromEye(CameraMatrices{to.camera.clipFromEye, to.eyeFromWorld},
                    CameraMatrices{from.camera.clipFromEye, from.eyeFromWorld});
}

}  // namespace gluray::scene
