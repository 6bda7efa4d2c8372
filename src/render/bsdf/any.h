// One of the models, chosen at each hit. Any thread.
#pragma once
#include "render/bsdf/conductor.h"
#include "render/bsdf/dielectric.h"
#include "render/bsdf/lambert.h"
#include "render/bsdf/mirror.h"
#include "render/bsdf/oren_nayar.h"
#include "render/bsdf/plastic.h"
#include "render/bsdf/principled.h"
#include "render/bsdf/thin_dielectric.h"
#include "render/bsdf/vtk_pbr.h"

#include <variant>

namespace gluray::render::bsdf {

using Any = std::variant<Lambert, OrenNayar, Plastic, Conductor, Dielectric, ThinDielectric, Mirror,
                         Principled, VtkPbr>;

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
