// The textures of physically based materials (scene::PbrSurface) at hits. Used by the kernels on tracing
// threads.
#pragma once
#include "render/local/textured_triangle.h"

#include <glm/glm.hpp>

namespace gluray::render {

/// What the textures give at a point.
struct PbrTexels {
  float occlusion = 1;                // visible share of the environment
  float roughness = 1, metallic = 1;  // factors of the material's
  glm::vec3 emission{1};              // likewise
  glm::vec3 normal{0, 0, 1};          // tangent space, unit length
  glm::vec3 tangent{0};               // of the vertices, interpolated; object space
};

/// Samples the textures of one surface. Caches the values that points of the same triangle share.
class PbrTextures {
 public:
  PbrTextures(const Surface&, const scene::Camera&);
  /// At (u, v) of a triangle and at a window position. `steps`: as in TexturedTriangle::color().
  PbrTexels at(uint32_t primitive, float u, float v, glm::dvec2 window, const WeightSteps* steps);

 private:
  const Surface& surface_;
  const scene::PbrSurface& pbr_;
  TexturedTriangle triangle_;
};

/// The normal that a normal map gives. `normal`, `tangent`: of the surface, in the same space; `normal` and
/// the result have unit length.
glm::vec3 mappedNormal(const glm::vec3& normal, const glm::vec3& tangent, const glm::vec3& texel);

}  // namespace gluray::render
