// Auxiliary features of pixels that mix several samples or layers. Any thread.
//
// Passes of the mode reflectance have sums over the samples of a pixel, as colours: red, green and blue, and
// in alpha the coverage, by which they are divided; below 0: the pixel shows only a shadow catcher. Passes of
// the mode geometry have mean planes of the samples that hit; c > 0 (markMixed()): of several surfaces.
#pragma once
#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace gluray::render {

/// Distance of a sample from the plane of another one, in widths of a pixel. `shift`: its position relative
/// to that, in pixels. Planes are (a, b, c, d) of render/effects/feature_integrators.h.
inline float distanceFromPlane(const glm::vec4& plane, const glm::vec4& sample, const glm::vec2& shift) {
  return plane.x * shift.x + plane.y * shift.y + plane.z * (1 - plane.w / sample.w);
}

/// Whether two samples of a pixel show one surface: on one plane, with about equal normals (26 degrees).
inline bool isOneSurface(const glm::vec4& a, const glm::vec4& b, float offPlane) {
  constexpr float kOffPlane = 0.5f, kCosine = 0.9f;  // pixels
  const auto z = [](const glm::vec4& p) { return std::sqrt(std::max(1 - p.x * p.x - p.y * p.y, 0.0f)); };
  return std::abs(offPlane) <= kOffPlane && a.x * b.x + a.y * b.y + z(a) * z(b) >= kCosine;
}

/// c of a mixed plane. It is above 0, also for c = 0.
inline float markMixed(float c) { return std::max(-c, 1e-6f); }

}  // namespace gluray::render
