// Directional albedo of rough surfaces for single scattering. The models add the energy of multiple
// scattering between facets (C. Kulla and A. Conty, "Revisiting Physically Based Shading at Imageworks",
// 2017). Any thread.
#pragma once
#include "render/bsdf/ggx.h"

namespace gluray::render::bsdf {

/// Albedo for light from one direction, if facets reflect f0 + (1 - f0) (1 - c)^5 (Schlick): f0 * scale +
/// bias.
struct GgxAlbedo {
  float scale, bias;
  float white() const { return scale + bias; }  // f0 = 1
  glm::vec3 reflectance(const glm::vec3& f0) const { return f0 * scale + bias; }
  float reflectance(float f0) const { return f0 * scale + bias; }
};

/// Interpolates a table, which the first call computes.
GgxAlbedo ggxAlbedo(float cosine, float alpha);

/// Cosine-weighted mean of the albedo over all directions.
GgxAlbedo ggxMeanAlbedo(float alpha);

}  // namespace gluray::render::bsdf
