// Texture coordinate generation at a vertex: GL 2.1, 2.11.4. Called on tracing threads.
#pragma once
#include "scene/texture_unit.h"

#include <glm/glm.hpp>

namespace gluray::render {

/// Inputs of coordinate generation. `eye` is the vertex in eye space, `normal` its eye-space normal as for
/// lighting.
struct TexGenVertex {
  glm::vec4 object{0, 0, 0, 1};
  glm::vec3 eye{0}, normal{0, 0, 1};
};

/// (s, t, r, q): generated coordinates; those not generated come from `given`.
glm::vec4 generateCoordinates(const scene::TexGen&, const TexGenVertex&, glm::vec4 given);

/// Whether the coordinates depend on normals.
bool needsNormal(const scene::TexGen&);

}  // namespace gluray::render
