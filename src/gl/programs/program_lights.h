// Reads a shader program's lights from the uniforms that its family names. GL thread.
#pragma once
#include "gl/programs/uniforms.h"
#include "scene/fragment_shading.h"

#include <vector>

namespace gluray::gl {

/// The lights that are on. Positions are relative to `viewer`; directions go from light to surface.
/// `shininess`: the material's. `most`: how many lights the program has; -1: not known.
std::vector<scene::FragmentLight> readLights(const FamilyLights& names, const UniformReader& uniforms,
                                             const glm::vec3& viewer, float shininess, int most);

}  // namespace gluray::gl
