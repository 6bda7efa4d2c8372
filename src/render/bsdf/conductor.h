// Metal: coloured reflection without transmission. Any thread.
#pragma once
#include "render/bsdf/fresnel.h"
#include "render/bsdf/rough_reflection.h"

namespace gluray::render::bsdf {

struct Conductor {
  glm::vec3 eta{1}, k{0};  // complex index of refraction, by colour
  Ggx ggx{0};
  glm::vec3 tint{1};  // factor without physical meaning

  glm::vec3 reflectance(float cosine) const { return fresnelConductor(cosine, eta, k); }
  /// Cosine-weighted mean reflectance over all directions, by Schlick's curve with the same reflectance at
  /// the normal.
  glm::vec3 mean() const { return (20.0f * reflectance(1) + 1.0f) / 21.0f; }

  glm::vec3 evaluate(const glm::vec3& wo, const glm::vec3& wi) const {
    if (ggx.isSmooth()) return glm::vec3(0);
    return tint * (reflectOnce(ggx, wo, wi, [&](float c) { return reflectance(c); }) +
                   reflectOften(ggx, wo, wi, mean()));
  }
  float pdf(const glm::vec3& wo, const glm::vec3& wi) const {
    if (ggx.isSmooth() || !(wo.z > 0 && wi.z > 0)) return 0;
    const float once = onceShare(wo);
    return once * reflectOncePdf(ggx, wo, wi) + (1 - once) * wi.z * kInversePi;
  }
  Scattered sample(const glm::vec3& wo, const glm::vec2& u, float lobe) const {
    if (ggx.isSmooth()) return {{-wo.x, -wo.y, wo.z}, tint * reflectance(wo.z), 0, true};
    const glm::vec3 wi = lobe < onceShare(wo) ? reflected(wo, ggx.visible(wo, u)) : cosineHemisphere(u);
    const float density = pdf(wo, wi);
    return {wi, density > 0 ? evaluate(wo, wi) / density : glm::vec3(0), density, false};
  }

 private:
  float onceShare(const glm::vec3& wo) const {
    return std::clamp(ggxAlbedo(wo.z, ggx.alpha).white(), 0.1f, 1.0f);
  }
};

}  // namespace gluray::render::bsdf
