// What rough surfaces reflect in all directions together when light meets one facet alone. The rest has met
// several, and is given back (C. Kulla and A. Conty, "Revisiting Physically Based Shading at Imageworks",
// 2017). Any thread.
#pragma once
#include "render/bsdf/ggx.h"

namespace gluray::render::bsdf {

/// Albedo under light from one direction of a surface whose facets reflect f0 + (1 - f0) (1 - c)^5 (Schlick):
/// f0 * scale + bias.
struct GgxAlbedo {
  float scale, bias;
  float white() const { return scale + bias; }  // f0 = 1
  glm::vec3 reflectance(const glm::vec3& f0) const { return f0 * scale + bias; }
  float reflectance(float f0) const { return f0 * scale + bias; }
};

/// From a table, made at the first call.
GgxAlbedo ggxAlbedo(float cosine, float alpha);

/// Its mean over all directions, weighted by the cosine.
GgxAlbedo ggxMeanAlbedo(float alpha);

}  // namespace gluray::render::bsdf
