// Microfacets of rough surfaces: the GGX distribution (B. Walter and others, "Microfacet Models for
// Refraction through Rough Surfaces", 2007), with sampling of visible normals (E. Heitz, "Sampling the GGX
// Distribution of Visible Normals", 2018). Any thread.
#pragma once
#include "render/bsdf/local_frame.h"

#include <algorithm>

namespace gluray::render::bsdf {

struct Ggx {
  float alpha;

  /// Squares the user's roughness, for a perceptually even scale.
  static Ggx ofRoughness(float roughness) { return {roughness * roughness}; }
  /// Whether the surface is treated as a mirror.
  bool isSmooth() const { return alpha < 1e-3f; }

  /// Distribution of facet normals, per solid angle and area.
  float density(const glm::vec3& h) const {
    if (h.z <= 0) return 0;
    const float a2 = alpha * alpha, d = (h.x * h.x + h.y * h.y) / a2 + h.z * h.z;
    return kInversePi / (a2 * d * d);
  }
  float lambda(const glm::vec3& w) const {
    const float cosine2 = w.z * w.z;
    if (!(cosine2 > 0)) return 1e20f;
    const float tangent2 = std::max(1 - cosine2, 0.0f) / cosine2;
    return 0.5f * (std::sqrt(1 + alpha * alpha * tangent2) - 1);
  }
  /// Masking: fraction of facets that are visible from w.
  float seen(const glm::vec3& w) const { return 1 / (1 + lambda(w)); }
  /// Masking and shadowing: fraction visible from both directions (height-correlated).
  float seen(const glm::vec3& wo, const glm::vec3& wi) const { return 1 / (1 + lambda(wo) + lambda(wi)); }
  /// Probability density of visible().
  float visibleDensity(const glm::vec3& wo, const glm::vec3& h) const {
    const float cosine = glm::dot(wo, h);
    return cosine > 0 ? seen(wo) / std::abs(wo.z) * density(h) * cosine : 0;
  }
  /// Samples the normal of a facet that is visible from wo, wo.z > 0.
  glm::vec3 visible(const glm::vec3& wo, const glm::vec2& u) const {
    const glm::vec3 v = glm::normalize(glm::vec3(alpha * wo.x, alpha * wo.y, wo.z));
    const float radius = std::sqrt(u.x), angle = 2 * kPi * u.y;
    const float x = radius * std::cos(angle);
    const float length = std::sqrt(v.x * v.x + v.y * v.y);
    const glm::vec3 t1 = length > 1e-6f ? glm::vec3(-v.y, v.x, 0) / length : glm::vec3(1, 0, 0);
    const glm::vec3 t2 = glm::cross(v, t1);
    const float half = 0.5f * (1 + v.z);
    const float y = glm::mix(std::sqrt(std::max(1 - x * x, 0.0f)), radius * std::sin(angle), half);
    const float z = std::sqrt(std::max(1 - x * x - y * y, 0.0f));
    const glm::vec3 n = x * t1 + y * t2 + z * v;
    return glm::normalize(glm::vec3(alpha * n.x, alpha * n.y, std::max(n.z, 1e-6f)));
  }
};

inline glm::vec3 reflected(const glm::vec3& w, const glm::vec3& h) { return 2 * glm::dot(w, h) * h - w; }

}  // namespace gluray::render::bsdf
