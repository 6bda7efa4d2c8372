// Mirror reflection, also used by smooth variants of other models. Any thread.
#pragma once
#include "render/bsdf/scattered.h"

namespace gluray::render::bsdf {

struct Mirror {
  glm::vec3 albedo{1};

  glm::vec3 evaluate(const glm::vec3&, const glm::vec3&) const { return glm::vec3(0); }
  float pdf(const glm::vec3&, const glm::vec3&) const { return 0; }
  Scattered sample(const glm::vec3& wo, const glm::vec2&, float) const {
    return {{-wo.x, -wo.y, wo.z}, albedo, 0, true};
  }
};

}  // namespace gluray::render::bsdf
