// How much of a surface's light comes from an area light, in closed form. Any thread.
#pragma once
#include "scene/light_source.h"

#include <glm/glm.hpp>

namespace gluray::render {

inline bool isArea(const scene::LightSource& l) {
  using Kind = scene::LightSource::Kind;
  return l.kind == Kind::rectangle || l.kind == Kind::disc || l.kind == Kind::sphere;
}

/// The integral of cos / pi over the directions in which a point sees a rectangle, disc or sphere above its
/// horizon: what a white diffuse surface shows of a light of radiance 1, 0 .. 1. Rectangles: J. Lambert,
/// 1760; spheres: J. Snyder, "Area Light Sources for Real-Time Graphics", 1996, and 1 inside of them. Discs
/// are polygons of as many corners that errors stay below 0.001. `normal`: unit length.
float formFactor(const scene::LightSource&, const glm::vec3& point, const glm::vec3& normal);

}  // namespace gluray::render
