// Rough matte surfaces, such as clay and the moon (M. Oren and S. Nayar, "Generalization of Lambert's
// Reflectance Model", 1994). Any thread.
#pragma once
#include "render/bsdf/scattered.h"

namespace gluray::render::bsdf {

struct OrenNayar {
  glm::vec3 albedo{1};
  float sigma = 0;  // standard deviation of the slope's angle, radians; 0: Lambert

  glm::vec3 evaluate(const glm::vec3& wo, const glm::vec3& wi) const {
    if (!(wo.z > 0 && wi.z > 0)) return glm::vec3(0);
    const float s2 = sigma * sigma, a = 1 - s2 / (2 * (s2 + 0.33f)), b = 0.45f * s2 / (s2 + 0.09f);
    const float sineO = std::sqrt(std::max(1 - wo.z * wo.z, 0.0f)),
                sineI = std::sqrt(std::max(1 - wi.z * wi.z, 0.0f));
    float between = 0;  // cosine of the azimuths' difference
    if (sineO > 1e-4f && sineI > 1e-4f)
      between = std::max((wo.x * wi.x + wo.y * wi.y) / (sineO * sineI), 0.0f);
    const float product = sineO * sineI / std::max(wo.z, wi.z);  // sin(alpha) tan(beta)
    return albedo * (wi.z * kInversePi * (a + b * between * product));
  }
  float pdf(const glm::vec3& wo, const glm::vec3& wi) const {
    return wo.z > 0 && wi.z > 0 ? wi.z * kInversePi : 0;
  }
  Scattered sample(const glm::vec3& wo, const glm::vec2& u, float) const {
    const glm::vec3 wi = cosineHemisphere(u);
    const float density = pdf(wo, wi);
    return {wi, density > 0 ? evaluate(wo, wi) / density : glm::vec3(0), density, false};
  }
};

}  // namespace gluray::render::bsdf
