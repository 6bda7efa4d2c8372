// Light from the environment of physically based materials (scene::PbrEnvironment). Used by the kernels on
// tracing threads.
#pragma once
#include "scene/fragment_shading.h"

#include <glm/glm.hpp>

namespace gluray::render {

/// Irradiance at a surface with the normal `normal`, unit length, in the program's eye space.
glm::vec3 irradianceOf(const scene::PbrEnvironment&, const glm::vec3& normal);

/// Light from direction `way`, unit length, in the program's eye space, blurred for the roughness.
glm::vec3 prefilteredFrom(const scene::PbrEnvironment&, const glm::vec3& way, float roughness);

/// The share of that light that is reflected: factors of the reflectances at normal and at grazing incidence.
glm::vec2 reflectedShares(const scene::PbrEnvironment&, float cosine, float roughness);

}  // namespace gluray::render
