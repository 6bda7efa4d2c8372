// Reads a shader program's lights from the uniforms that its family names. GL thread.
#pragma once
#include "gl/programs/match.h"
#include "gl/programs/uniforms.h"
#include "scene/fragment_shading.h"

#include <vector>

namespace gluray::gl {

/// The lights that are on. Positions are relative to `viewer`; directions go from light to surface.
/// `shininess`: the material's. `known`: how many lights and highlights the program has.
std::vector<scene::FragmentLight> readLights(const FamilyLights& names, const UniformReader& uniforms,
                                             const glm::vec3& viewer, float shininess,
                                             const KnownProgram& known);

}  // namespace gluray::gl
