// Texels of a texture by the wrap modes and filters of OpenGL. Called by the kernels on tracing threads.
#pragma once
#include "scene/texture.h"

#include <glm/glm.hpp>

namespace gluray::render {

/// RGBA of one level at normalised coordinates, filtered, by the texture's wrap modes. Of cube maps (s, t)
/// lie within a face and r is its number. Source: GL 2.1, 3.8.7 to 3.8.9.
glm::vec4 sampleLevel(const scene::Texture&, const scene::TexelGrid&, scene::Filter, glm::vec3 str);

/// The face of a cube map that a direction meets, as sampleLevel() takes it. GL 2.1, table 3.19.
int cubeFace(glm::dvec3 direction);
/// A direction's parts across, along and out of the face: (sc, tc, ma) of the table.
glm::dvec3 alongFace(int face, glm::dvec3 direction);
glm::dvec2 coordinatesInFace(int face, glm::dvec3 direction);

}  // namespace gluray::render
