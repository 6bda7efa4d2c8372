// A diffuse base under a clear coat. The coat transmits the light that it does not reflect (C. Kelemen and L.
// Szirmay-Kalos, "A Microfacet Based Coupled Specular-Matte BRDF Model", 2001). Any thread.
#pragma once
#include "render/bsdf/fresnel.h"
#include "render/bsdf/rough_reflection.h"

namespace gluray::render::bsdf {

struct Plastic {
  glm::vec3 albedo{1};
  float f0 = 0.04f;  // reflectance of the coat at its normal
  Ggx ggx{0};        // of the coat

  glm::vec3 evaluate(const glm::vec3& wo, const glm::vec3& wi) const {
    if (!(wo.z > 0 && wi.z > 0)) return glm::vec3(0);
    const glm::vec3 body = albedo * (below(wo.z) * below(wi.z) / (1 - coatMean()) * kInversePi * wi.z);
    if (ggx.isSmooth()) return body;
    return body + reflectOnce(ggx, wo, wi, [&](float c) { return fresnelSchlick(c, glm::vec3(f0)); });
  }
  float pdf(const glm::vec3& wo, const glm::vec3& wi) const {
    if (!(wo.z > 0 && wi.z > 0)) return 0;
    const float share = coatShare(wo);
    const float once = ggx.isSmooth() ? 0 : reflectOncePdf(ggx, wo, wi);
    return share * once + (1 - share) * wi.z * kInversePi;
  }
  Scattered sample(const glm::vec3& wo, const glm::vec2& u, float lobe) const {
    const float share = coatShare(wo);
    if (lobe < share && ggx.isSmooth()) return {{-wo.x, -wo.y, wo.z}, glm::vec3(coat(wo.z) / share), 0, true};
    const glm::vec3 wi = lobe < share ? reflected(wo, ggx.visible(wo, u)) : cosineHemisphere(u);
    const float density = pdf(wo, wi);
    return {wi, density > 0 ? evaluate(wo, wi) / density : glm::vec3(0), density, false};
  }

 private:
  /// Albedo of the coat for light from one direction.
  float coat(float cosine) const {
    return ggx.isSmooth() ? fresnelSchlick(cosine, glm::vec3(f0)).x
                          : ggxAlbedo(cosine, ggx.alpha).reflectance(f0);
  }
  float below(float cosine) const { return 1 - coat(cosine); }
  float coatMean() const {
    return ggx.isSmooth() ? f0 + (1 - f0) / 21 : ggxMeanAlbedo(ggx.alpha).reflectance(f0);
  }
  /// Probability of sampling the coat.
  float coatShare(const glm::vec3& wo) const {
    const float shine = coat(wo.z), body = (1 - shine) * std::max({albedo.x, albedo.y, albedo.z});
    return std::clamp(shine / std::max(shine + body, 1e-6f), 0.05f, 0.95f);
  }
};

}  // namespace gluray::render::bsdf
