// Reads a shader program's lights from the uniforms that its family names. GL thread.
#pragma once
#include "gl/programs/uniforms.h"
#include "scene/fragment_shading.h"

#include <vector>

namespace gluray::gl {

/// The lights that are on. Positions are relative to `viewer`; directions go from light to surface.
std::vector<scene::FragmentLight> readLights(const FamilyLights& names, const UniformReader& uniforms,
                                             const glm::vec3& viewer);

}  // namespace gluray::gl
