// Ideal diffuse reflection. Any thread.
#pragma once
#include "render/bsdf/scattered.h"

namespace gluray::render::bsdf {

struct Lambert {
  glm::vec3 albedo{1};

  glm::vec3 evaluate(const glm::vec3& wo, const glm::vec3& wi) const { return albedo * pdf(wo, wi); }
  float pdf(const glm::vec3& wo, const glm::vec3& wi) const {
    return wo.z > 0 && wi.z > 0 ? wi.z * kInversePi : 0;
  }
  Scattered sample(const glm::vec3& wo, const glm::vec2& u, float) const {
    const glm::vec3 wi = cosineHemisphere(u);
    return {wi, wo.z > 0 ? albedo : glm::vec3(0), wi.z * kInversePi, false};
  }
};

}  // namespace gluray::render::bsdf
