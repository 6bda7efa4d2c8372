// Texture sampling with OpenGL's wrap modes and filters. Called by the kernels on tracing threads.
#pragma once
#include "scene/texture.h"

#include <glm/glm.hpp>

namespace gluray::render {

/// Filtered RGBA of one level at normalised coordinates, with the texture's wrap modes. For cube maps (s, t)
/// are within a face and r is its number. Source: GL 2.1, 3.8.7 to 3.8.9.
glm::vec4 sampleLevel(const scene::Texture&, const scene::TexelGrid&, scene::Filter, glm::vec3 str);

/// Number of the cube map face in this direction, for sampleLevel(). GL 2.1, table 3.19.
int cubeFace(glm::dvec3 direction);
/// A direction's components relative to a face: (sc, tc, ma) of the table.
glm::dvec3 alongFace(int face, glm::dvec3 direction);
glm::dvec2 coordinatesInFace(int face, glm::dvec3 direction);

}  // namespace gluray::render
