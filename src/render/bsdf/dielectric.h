// Glass and water: reflection and refraction. Differs: radiance behind the boundary is not scaled by the
// squared index of refraction; the factors cancel when light leaves the body. Any thread.
#pragma once
#include "render/bsdf/fresnel.h"
#include "render/bsdf/ggx.h"
#include "render/bsdf/scattered.h"

namespace gluray::render::bsdf {

struct Dielectric {
  float eta = 1.5f;  // index of refraction behind the boundary, wi.z < 0, over that before it, wo.z > 0
  Ggx ggx{0};
  glm::vec3 tint{1};  // of transmitted light

  glm::vec3 evaluate(const glm::vec3& wo, const glm::vec3& wi) const {
    if (ggx.isSmooth() || !(wo.z > 0) || wi.z == 0) return glm::vec3(0);
    const glm::vec3 h = facet(wo, wi);
    const float cosO = glm::dot(wo, h), cosI = glm::dot(wi, h);
    if (cosO <= 0 || cosI * wi.z < 0) return glm::vec3(0);
    const float reflectance = fresnel(cosO, eta);
    if (wi.z > 0) return glm::vec3(reflectance * ggx.density(h) * ggx.seen(wo, wi) / (4 * wo.z));
    const float root = cosI + cosO / eta;
    return tint * ((1 - reflectance) * ggx.density(h) * ggx.seen(wo, wi) *
                   std::abs(cosI * cosO / (wo.z * root * root)));
  }
  float pdf(const glm::vec3& wo, const glm::vec3& wi) const {
    if (ggx.isSmooth() || !(wo.z > 0) || wi.z == 0) return 0;
    const glm::vec3 h = facet(wo, wi);
    const float cosO = glm::dot(wo, h), cosI = glm::dot(wi, h);
    if (cosO <= 0 || cosI * wi.z < 0) return 0;
    const float reflectance = fresnel(cosO, eta), facets = ggx.visibleDensity(wo, h);
    if (wi.z > 0) return reflectance * facets / (4 * cosO);
    const float root = cosI + cosO / eta;
    return (1 - reflectance) * facets * std::abs(cosI) / (root * root);
  }
  Scattered sample(const glm::vec3& wo, const glm::vec2& u, float lobe) const {
    const bool smooth = ggx.isSmooth();
    const glm::vec3 h = smooth ? glm::vec3(0, 0, 1) : ggx.visible(wo, u);
    const float reflectance = fresnel(std::min(glm::dot(wo, h), 1.0f), eta);
    glm::vec3 wi;
    const bool reflects = lobe < reflectance || !refract(wo, h, eta, wi);
    if (reflects) wi = reflected(wo, h);
    if (reflects ? wi.z <= 0 : wi.z >= 0) return {};  // lost at a second facet
    if (smooth) return {wi, reflects ? glm::vec3(1) : tint, 0, true};
    const float density = pdf(wo, wi);
    return {wi, density > 0 ? evaluate(wo, wi) / density : glm::vec3(0), density, false};
  }

 private:
  /// Normal of the facets that scatter light from wi to wo.
  glm::vec3 facet(const glm::vec3& wo, const glm::vec3& wi) const {
    const glm::vec3 h = glm::normalize(wi.z > 0 ? wo + wi : wo + wi * eta);
    return h.z < 0 ? -h : h;
  }
};

}  // namespace gluray::render::bsdf
