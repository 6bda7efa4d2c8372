// One of the models, chosen at each hit. Any thread.
#pragma once
#include "render/bsdf/lambert.h"

#include <variant>

namespace gluray::render::bsdf {

using Any = std::variant<Lambert>;

inline glm::vec3 evaluate(const Any& any, const glm::vec3& wo, const glm::vec3& wi) {
  return std::visit([&](const auto& model) { return model.evaluate(wo, wi); }, any);
}
inline float pdf(const Any& any, const glm::vec3& wo, const glm::vec3& wi) {
  return std::visit([&](const auto& model) { return model.pdf(wo, wi); }, any);
}
inline Scattered sample(const Any& any, const glm::vec3& wo, const glm::vec2& u, float lobe) {
  return std::visit([&](const auto& model) { return model.sample(wo, u, lobe); }, any);
}

}  // namespace gluray::render::bsdf
