// How wide a pixel is where paths meet surfaces, so that textures are filtered there, too (T. Akenine-Möller
// and others, "Improved Shader and Texture Level of Detail Using Ray Cones", 2021). Any thread.
#pragma once
#include "render/camera/ray_setup.h"
#include "render/local/group.h"

#include <glm/glm.hpp>

namespace gluray::render {

/// Widths across the ray, eye space. Differs: the spread does not grow by the curvature of mirrors.
struct RayCone {
  float width = 0;   // where the ray begins
  float spread = 0;  // what it grows by on a way of length 1
  float widthAt(float distance) const { return width + spread * distance; }
};

/// Where the viewer sees an eye-space point at a window position. The widest side of the pixel counts.
RayCone coneAt(const RaySetup& eyeRays, double x, double y, const glm::vec3& point);

/// After a bounce in a direction of this density, of so many that are drawn: each stands for its share of
/// directions. Cones have at most 0.2 of it, because wider ones blur more than their texture.
RayCone scattered(const RayCone&, float pdf, int samples);

/// The pixel's longest and shortest extent on a triangle as changes of the corners' weights. `way`: along the
/// ray, unit length. None for a triangle without area.
WeightSteps stepsOn(const glm::dvec3 (&corner)[3], const glm::dvec3& way, double width);

}  // namespace gluray::render
