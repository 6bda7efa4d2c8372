// VTK's physically based shading, term by term as its programs have it
// (render/shading/fragment_program.inl.h). Differs from the other models: masking uses the squared roughness,
// the distribution its fourth power, and the energy of multiple scattering is lost. Any thread.
#pragma once
#include "render/bsdf/fresnel.h"
#include "render/bsdf/rough_reflection.h"

namespace gluray::render::bsdf {

struct VtkPbr {
  glm::vec3 albedo{1};
  float metallic = 0, roughness = 0.5f, baseF0 = 0.04f;
  glm::vec3 edgeTint{1};
  float distributionFloor = 0;  // scene::PbrSurface

  glm::vec3 evaluate(const glm::vec3& wo, const glm::vec3& wi) const {
    if (!(wo.z > 0 && wi.z > 0)) return glm::vec3(0);
    const glm::vec3 h = glm::normalize(wo + wi);
    const float a2 = roughness * roughness, a4 = a2 * a2;
    const float d = h.z * h.z * (a4 - 1) + 1, divisor = std::max(d * d, distributionFloor * kInversePi),
                distribution = a4 * kInversePi / divisor;
    const auto smith = [&](float x, float y) { return y * std::sqrt(x * x * (1 - a2) + a2); };
    const float visibility = 0.5f / (smith(wo.z, wi.z) + smith(wi.z, wo.z));
    const glm::vec3 f = reflectance(std::clamp(glm::dot(wi, h), 1e-5f, 1.0f));
    return wi.z * ((1.0f - f) * albedo * ((1 - metallic) * kInversePi) + f * (distribution * visibility));
  }
  float pdf(const glm::vec3& wo, const glm::vec3& wi) const {
    if (!(wo.z > 0 && wi.z > 0)) return 0;
    const float shine = shineShare();
    return shine * reflectOncePdf(ggx(), wo, wi) + (1 - shine) * wi.z * kInversePi;
  }
  Scattered sample(const glm::vec3& wo, const glm::vec2& u, float lobe) const {
    const glm::vec3 wi = lobe < shineShare() ? reflected(wo, ggx().visible(wo, u)) : cosineHemisphere(u);
    const float density = pdf(wo, wi);
    return {wi, density > 0 ? evaluate(wo, wi) / density : glm::vec3(0), density, false};
  }

 private:
  Ggx ggx() const { return {std::max(roughness * roughness, 1e-3f)}; }
  float shineShare() const { return 0.3f + 0.6f * metallic; }
  glm::vec3 reflectance(float cosine) const {
    const glm::vec3 f0 = glm::mix(glm::vec3(baseF0), albedo, metallic);
    const float grey = std::clamp(16.5f * (f0.x + f0.y + f0.z), 0.0f, 1.0f);
    const glm::vec3 f90 = glm::mix(glm::vec3(grey), edgeTint, metallic);
    const float away = 1 - cosine, away2 = away * away;
    return f0 + (f90 - f0) * (away2 * away2 * away);
  }
};

}  // namespace gluray::render::bsdf
