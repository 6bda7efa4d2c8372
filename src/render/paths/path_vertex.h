// A point where a path of light meets a surface. Made by path_vertices.inl.h, one for each lane of a packet.
#pragma once
#include "render/local/group.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace gluray::render {

/// Vectors are in eye space; both normals are of unit length and on the side that the path comes from.
struct PathVertex {
  glm::vec3 point{0};
  glm::vec3 geometric{0, 0, 1}, shading{0, 0, 1};
  glm::vec3 lift{0};      // from the triangle to the curved surface that it stands for
  float error = 0;        // bound of the rounding errors of `point`
  glm::vec3 albedo{0};    // the surface's own colour
  glm::vec3 emission{0};  // radiance that the surface gives off; without lighting: its colour
  glm::vec3 specular{0};  // colour of the highlights that the program's equation has
  float shininess = 0;    // their exponent
  float opacity = 1;      // the rest goes straight through
  uint32_t instance = 0;
  bool front = true;  // the path comes from the side that the surface's winding calls its front
};

struct PathVertices {
  PathVertex lane[kLanes];
};

}  // namespace gluray::render
