// Lights of a shader program, by the names that its family gives them. GL thread.
#pragma once
#include "gl/programs/uniforms.h"
#include "scene/fragment_shading.h"

#include <vector>

namespace gluray::gl {

/// The lights that are on. Positions are counted from `viewer`, directions go from the light to the surface.
std::vector<scene::FragmentLight> readLights(const FamilyLights& names, const UniformReader& uniforms,
                                             const glm::vec3& viewer);

}  // namespace gluray::gl
