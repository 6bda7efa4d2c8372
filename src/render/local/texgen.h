// Texture coordinate generation: GL 2.1, 2.11.4, at a vertex. Called on tracing threads.
#pragma once
#include "scene/texture_unit.h"

#include <glm/glm.hpp>

namespace gluray::render {

/// What coordinates are made of. `eye` is the vertex and `normal` its normal in eye space, the latter as
/// lighting would take it.
struct TexGenVertex {
  glm::vec4 object{0, 0, 0, 1};
  glm::vec3 eye{0}, normal{0, 0, 1};
};

/// (s, t, r, q): those that are generated; the others from `given`.
glm::vec4 generateCoordinates(const scene::TexGen&, const TexGenVertex&, glm::vec4 given);

/// Whether normals enter the coordinates.
bool needsNormal(const scene::TexGen&);

}  // namespace gluray::render
