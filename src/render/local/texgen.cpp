#include "render/local/texgen.h"

#include <algorithm>
#include <cmath>

namespace gluray::render {
namespace {

using scene::TexGen;

/// The direction of a ray from the eye after reflection at the vertex.
glm::vec3 reflection(const TexGenVertex& v) {
  const float length = glm::length(v.eye);
  const glm::vec3 u = length > 0 ? v.eye / length : v.eye;
  return u - 2.0f * v.normal * glm::dot(v.normal, u);
}

}  // namespace

glm::vec4 generateCoordinates(const TexGen& gen, const TexGenVertex& v, glm::vec4 given) {
  const glm::vec3 r = reflection(v);
  const float m = 2 * std::sqrt(r.x * r.x + r.y * r.y + (r.z + 1) * (r.z + 1));
  for (int i = 0; i < 4; ++i) {
    const TexGen::Coordinate& c = gen.coordinates[static_cast<size_t>(i)];
    const int axis = std::min(i, 2);  // q has no mode that uses it
    switch (c.mode) {
      case TexGen::off: break;
      case TexGen::objectLinear: given[i] = glm::dot(c.plane, v.object); break;
      case TexGen::eyeLinear: given[i] = glm::dot(c.plane, glm::vec4(v.eye, 1)); break;
      case TexGen::sphereMap: given[i] = r[axis] / m + 0.5f; break;
      case TexGen::normalMap: given[i] = v.normal[axis]; break;
      case TexGen::reflectionMap: given[i] = r[axis]; break;
    }
  }
  return given;
}

bool needsNormal(const TexGen& gen) {
  return std::any_of(gen.coordinates.begin(), gen.coordinates.end(),
                     [](const TexGen::Coordinate& c) { return c.mode >= TexGen::sphereMap; });
}

}  // namespace gluray::render
