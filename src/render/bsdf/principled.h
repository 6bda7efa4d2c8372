// One model for most materials: metal, plastic and glass mixed by weights, under a coat (after B. Burley,
// "Physically Based Shading at Disney", 2012, in the parameters; the lobes are those of the other models
// here). Any thread.
#pragma once
#include "render/bsdf/dielectric.h"
#include "render/bsdf/plastic.h"

namespace gluray::render::bsdf {

struct Principled {
  glm::vec3 color{1};
  float metallic = 0, specular = 0.5f, transmission = 0, coat = 0;
  float eta = 1.5f;  // for transmission: index of refraction behind the boundary / in front of it
  Ggx ggx{0.25f};

  glm::vec3 evaluate(const glm::vec3& wo, const glm::vec3& wi) const {
    glm::vec3 sum(0);
    if (metallic > 0) sum += metallic * metalBody(wo, wi);
    if (plasticShare() > 0) sum += plasticShare() * plasticBody().evaluate(wo, wi);
    if (glassShare() > 0) sum += glassShare() * glassBody().evaluate(wo, wi);
    if (coat == 0) return sum;
    const glm::vec3 shine =
        reflectOnce(kCoat, wo, wi, [](float c) { return fresnelSchlick(c, glm::vec3(kCoatF0)); });
    return sum * (underCoat(wo) * underCoat(wi)) + coat * shine;
  }

  float pdf(const glm::vec3& wo, const glm::vec3& wi) const {
    float sum = 0;
    if (metallic > 0 && !ggx.isSmooth()) sum += metallic * metalPdf(wo, wi);
    if (plasticShare() > 0) sum += plasticShare() * plasticBody().pdf(wo, wi);
    if (glassShare() > 0) sum += glassShare() * glassBody().pdf(wo, wi);
    const float above = coatShare(wo);
    return (1 - above) * sum + (above > 0 ? above * reflectOncePdf(kCoat, wo, wi) : 0);
  }

  Scattered sample(const glm::vec3& wo, const glm::vec2& u, float lobe) const {
    const float above = coatShare(wo);
    Scattered next;
    if (lobe < above) {
      next.wi = reflected(wo, kCoat.visible(wo, u));
    } else {
      next = sampleBody(wo, u, std::min((lobe - above) / (1 - above), 0x1.fffffep-1f));
      if (next.exact) {
        next.weight *= underCoat(wo) * underCoat(next.wi) / (1 - above);
        return next;
      }
    }
    next.pdf = pdf(wo, next.wi);
    next.weight = next.pdf > 0 ? evaluate(wo, next.wi) / next.pdf : glm::vec3(0);
    return next;
  }

 private:
  static constexpr Ggx kCoat{0.01f};
  static constexpr float kCoatF0 = 0.04f;

  float plasticShare() const { return (1 - metallic) * (1 - transmission); }
  float glassShare() const { return (1 - metallic) * transmission; }
  Plastic plasticBody() const { return {color, 0.08f * specular, ggx}; }
  Dielectric glassBody() const { return {eta, ggx, color}; }
  float coatOf(const glm::vec3& w) const {
    return coat * ggxAlbedo(std::abs(w.z), kCoat.alpha).reflectance(kCoatF0);
  }
  float underCoat(const glm::vec3& w) const { return coat == 0 ? 1 : 1 - coatOf(w); }
  /// Probability of sampling the coat.
  float coatShare(const glm::vec3& wo) const { return coat == 0 ? 0 : std::clamp(coatOf(wo), 0.05f, 0.9f); }

  glm::vec3 metalBody(const glm::vec3& wo, const glm::vec3& wi) const {
    if (ggx.isSmooth()) return glm::vec3(0);
    return reflectOnce(ggx, wo, wi, [&](float c) { return fresnelSchlick(c, color); }) +
           reflectOften(ggx, wo, wi, (20.0f * color + 1.0f) / 21.0f);
  }
  float onceShare(const glm::vec3& wo) const {
    return std::clamp(ggxAlbedo(wo.z, ggx.alpha).white(), 0.1f, 1.0f);
  }
  float metalPdf(const glm::vec3& wo, const glm::vec3& wi) const {
    if (!(wo.z > 0 && wi.z > 0)) return 0;
    const float once = onceShare(wo);
    return once * reflectOncePdf(ggx, wo, wi) + (1 - once) * wi.z * kInversePi;
  }
  Scattered sampleMetal(const glm::vec3& wo, const glm::vec2& u, float lobe) const {
    if (ggx.isSmooth()) return {{-wo.x, -wo.y, wo.z}, fresnelSchlick(wo.z, color), 0, true};
    return {lobe < onceShare(wo) ? reflected(wo, ggx.visible(wo, u)) : cosineHemisphere(u)};
  }
  Scattered sampleBody(const glm::vec3& wo, const glm::vec2& u, float lobe) const {
    const float metal = metallic, plastic = plasticShare();
    if (lobe < metal) return sampleMetal(wo, u, lobe / metal);
    if (lobe < metal + plastic) return plasticBody().sample(wo, u, (lobe - metal) / plastic);
    if (glassShare() <= 0) return {};
    return glassBody().sample(wo, u, std::min((lobe - metal - plastic) / glassShare(), 0x1.fffffep-1f));
  }
};

}  // namespace gluray::render::bsdf
