// A vertex of a path. Made by path_vertices.inl.h, one for each lane of a packet.
#pragma once
#include "render/local/group.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace gluray::render {

/// Vectors are in eye space; both normals have unit length and are on the side from which the path arrives.
struct PathVertex {
  glm::vec3 point{0};
  glm::vec3 geometric{0, 0, 1}, shading{0, 0, 1};
  glm::vec3 lift{0};                     // from the triangle to the curved surface that it approximates
  float error = 0;                       // bound of the rounding errors of `point`
  glm::vec3 albedo{0};                   // the surface's own colour
  glm::vec3 emission{0};                 // emitted radiance; without lighting: the surface's colour
  glm::vec3 specular{0};                 // specular colour in the program's equation
  float shininess = 0;                   // their exponent
  float opacity = 1;                     // the rest goes straight through
  float metallic = 0, roughness = 0.5f;  // of physically based materials
  uint32_t instance = 0;
  bool front = true;  // the path arrives from the front side by winding
};

struct PathVertices {
  PathVertex lane[kLanes];
};

}  // namespace gluray::render
