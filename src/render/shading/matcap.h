// Colours by images that the normal looks up (scene::FragmentShading::matcap). Used by the kernels on tracing
// threads.
#pragma once
#include "scene/fragment_shading.h"

#include <glm/glm.hpp>

namespace gluray::render {

/// What a surface of `color` shows, whose normal has unit length, in the program's eye space.
glm::vec3 throughMatcap(const scene::FragmentShading&, const glm::vec3& color, const glm::vec3& normal);

}  // namespace gluray::render
