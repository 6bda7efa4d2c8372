// Pixel footprints at path vertices, for texture filtering (T. Akenine-Möller and others, "Improved Shader
// and Texture Level of Detail Using Ray Cones", 2021). Any thread.
#pragma once
#include "render/camera/ray_setup.h"
#include "render/local/group.h"

#include <glm/glm.hpp>

namespace gluray::render {

/// Widths across the ray, eye space. Differs: the curvature of mirrors does not increase the spread.
struct RayCone {
  float width = 0;   // at the ray's origin
  float spread = 0;  // growth per unit distance
  float widthAt(float distance) const { return width + spread * distance; }
};

/// Cone of the primary ray at an eye-space point and a window position; uses the widest side of the pixel.
RayCone coneAt(const RaySetup& eyeRays, double x, double y, const glm::vec3& point);

/// Cone after a bounce with density `pdf`, if `samples` directions are sampled: each covers its share of
/// directions. Cones are limited to 0.2 of that share, because wider cones blur too much.
RayCone scattered(const RayCone&, float pdf, int samples);

/// The pixel's longest and shortest extent on a triangle as changes of the corners' weights. `way`: along the
/// ray, unit length. Zero for a triangle without area.
WeightSteps stepsOn(const glm::dvec3 (&corner)[3], const glm::dvec3& way, double width);

}  // namespace gluray::render
