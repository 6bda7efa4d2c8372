// A thin pane with both sides in one surface: transmits light straight, and reflects it, with all reflections
// between the two sides. Any thread.
#pragma once
#include "render/bsdf/fresnel.h"
#include "render/bsdf/scattered.h"

namespace gluray::render::bsdf {

struct ThinDielectric {
  float eta = 1.5f;
  glm::vec3 tint{1};  // of transmitted light

  /// Reflectance of both sides together: R + T^2 R + T^2 R^3 + ...
  float reflectance(float cosine) const {
    const float once = fresnel(cosine, eta);
    return 2 * once / (1 + once);
  }
  glm::vec3 evaluate(const glm::vec3&, const glm::vec3&) const { return glm::vec3(0); }
  float pdf(const glm::vec3&, const glm::vec3&) const { return 0; }
  Scattered sample(const glm::vec3& wo, const glm::vec2&, float lobe) const {
    if (lobe < reflectance(wo.z)) return {{-wo.x, -wo.y, wo.z}, glm::vec3(1), 0, true};
    return {-wo, tint, 0, true};
  }
};

}  // namespace gluray::render::bsdf
