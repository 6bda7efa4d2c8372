// Fresnel reflectance of the boundary between two media. Any thread.
#pragma once
#include <glm/glm.hpp>

#include <cmath>

namespace gluray::render::bsdf {

/// Reflectance for unpolarised light with incident cosine `cosine` >= 0; `eta`: index of refraction behind
/// the boundary divided by that in front of it. Returns 1 for total reflection.
inline float fresnel(float cosine, float eta) {
  const float sine2 = (1 - cosine * cosine) / (eta * eta);
  if (sine2 >= 1) return 1;
  const float behind = std::sqrt(1 - sine2);
  const float parallel = (eta * cosine - behind) / (eta * cosine + behind),
              perpendicular = (cosine - eta * behind) / (cosine + eta * behind);
  return 0.5f * (parallel * parallel + perpendicular * perpendicular);
}

/// Reflectance of a conductor with the complex index eta + i k, by colour (M. Born and E. Wolf, "Principles
/// of Optics", 14.2).
inline glm::vec3 fresnelConductor(float cosine, const glm::vec3& eta, const glm::vec3& k) {
  const float cosine2 = cosine * cosine, sine2 = 1 - cosine2;
  const glm::vec3 eta2 = eta * eta, k2 = k * k, t0 = eta2 - k2 - sine2;
  const glm::vec3 a2b2 = glm::sqrt(t0 * t0 + 4.0f * eta2 * k2), t1 = a2b2 + cosine2;
  const glm::vec3 a = glm::sqrt(glm::max(0.5f * (a2b2 + t0), 0.0f)), t2 = 2.0f * cosine * a;
  const glm::vec3 perpendicular = (t1 - t2) / (t1 + t2);
  const glm::vec3 t3 = cosine2 * a2b2 + sine2 * sine2, t4 = t2 * sine2;
  return 0.5f * (perpendicular + perpendicular * (t3 - t4) / (t3 + t4));
}

/// C. Schlick's approximation, 1994: from `f0` at the normal to 1 at grazing angles.
inline glm::vec3 fresnelSchlick(float cosine, const glm::vec3& f0) {
  const float away = 1 - cosine, away2 = away * away;
  return f0 + (1.0f - f0) * (away2 * away2 * away);
}

/// Reflectance at the normal of the boundary between media of relative index `eta`.
inline float reflectanceAtNormal(float eta) { return (eta - 1) * (eta - 1) / ((eta + 1) * (eta + 1)); }

/// Refracts by Snell's law: computes the direction behind the boundary of light that leaves towards `wo`, z >
/// 0. Returns false for total reflection.
inline bool refract(const glm::vec3& wo, const glm::vec3& normal, float eta, glm::vec3& out) {
  const float cosine = glm::dot(wo, normal), sine2 = (1 - cosine * cosine) / (eta * eta);
  if (sine2 >= 1) return false;
  out = glm::normalize(-wo / eta + (cosine / eta - std::sqrt(1 - sine2)) * normal);
  return true;
}

}  // namespace gluray::render::bsdf
