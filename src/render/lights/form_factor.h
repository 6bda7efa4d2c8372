// Form factors of area lights in closed form. Any thread.
#pragma once
#include "scene/light_source.h"

#include <glm/glm.hpp>

namespace gluray::render {

inline bool isArea(const scene::LightSource& l) {
  using Kind = scene::LightSource::Kind;
  return l.kind == Kind::rectangle || l.kind == Kind::disc || l.kind == Kind::sphere;
}

/// Integrates cos / pi over the solid angle of a rectangle, disc or sphere above the point's horizon: the
/// colour, 0 .. 1, of a white diffuse surface under a light of radiance 1. Rectangles: J. Lambert, 1760;
/// spheres: J. Snyder, "Area Light Sources for Real-Time Graphics", 1996; 1 inside of a sphere. Discs are
/// approximated by polygons with errors below 0.001. `normal`: unit length.
float formFactor(const scene::LightSource&, const glm::vec3& point, const glm::vec3& normal);

}  // namespace gluray::render
