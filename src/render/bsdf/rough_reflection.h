// Reflection of rough surfaces, shared by several models. Any thread.
#pragma once
#include "render/bsdf/ggx_energy.h"
#include "render/bsdf/scattered.h"

namespace gluray::render::bsdf {

/// Single scattering. `reflectance(cosine)`: reflectance of a facet.
template <class Reflectance>
glm::vec3 reflectOnce(const Ggx& ggx, const glm::vec3& wo, const glm::vec3& wi,
                      const Reflectance& reflectance) {
  if (!(wo.z > 0 && wi.z > 0)) return glm::vec3(0);
  const glm::vec3 h = glm::normalize(wo + wi);
  return reflectance(std::min(glm::dot(wo, h), 1.0f)) * (ggx.density(h) * ggx.seen(wo, wi) / (4 * wo.z));
}

inline float reflectOncePdf(const Ggx& ggx, const glm::vec3& wo, const glm::vec3& wi) {
  if (!(wo.z > 0 && wi.z > 0)) return 0;
  const glm::vec3 h = glm::normalize(wo + wi);
  const float cosine = glm::dot(wo, h);
  return cosine > 0 ? ggx.visibleDensity(wo, h) / (4 * cosine) : 0;
}

/// Multiple scattering between facets: a diffuse lobe with the energy that reflectOnce() loses. `mean`:
/// reflectance of facets, averaged over all directions.
inline glm::vec3 reflectOften(const Ggx& ggx, const glm::vec3& wo, const glm::vec3& wi,
                              const glm::vec3& mean) {
  if (!(wo.z > 0 && wi.z > 0)) return glm::vec3(0);
  const float all = ggxMeanAlbedo(ggx.alpha).white();
  const float lostO = 1 - ggxAlbedo(wo.z, ggx.alpha).white(), lostI = 1 - ggxAlbedo(wi.z, ggx.alpha).white();
  if (!(all < 1)) return glm::vec3(0);
  const glm::vec3 color = mean * mean * all / (1.0f - mean * (1 - all));
  return color * std::max(lostO * lostI / (1 - all) * kInversePi * wi.z, 0.0f);
}

}  // namespace gluray::render::bsdf
