// Reads a shader program's lights from the uniforms that its family names. GL thread.
#pragma once
#include "gl/programs/match.h"
#include "gl/programs/uniforms.h"
#include "scene/fragment_shading.h"

#include <vector>

namespace gluray::gl {

/// The lights that are on. Positions are relative to `viewer`; directions point from light to surface.
/// `shininess`: that of the material. `known`: the numbers of lights and highlights of the program.
std::vector<scene::FragmentLight> readLights(const FamilyLights& names, const UniformReader& uniforms,
                                             const glm::vec3& viewer, float shininess,
                                             const KnownProgram& known);

}  // namespace gluray::gl
