// Local shading space: z along the normal. Any thread.
#pragma once
#include <glm/glm.hpp>

#include <cmath>

namespace gluray::render::bsdf {

constexpr float kPi = 3.14159265358979f, kInversePi = 0.31830988618379f;

/// An orthonormal basis about a unit vector (T. Duff and others, "Building an Orthonormal Basis, Revisited",
/// 2017).
struct LocalFrame {
  glm::vec3 x, y, z;
  explicit LocalFrame(const glm::vec3& n) : z(n) {
    const float sign = std::copysign(1.0f, n.z), a = -1 / (sign + n.z), b = n.x * n.y * a;
    x = {1 + sign * n.x * n.x * a, sign * b, -sign * n.x};
    y = {b, sign + n.y * n.y * a, -n.y};
  }
  glm::vec3 toLocal(const glm::vec3& v) const { return {glm::dot(v, x), glm::dot(v, y), glm::dot(v, z)}; }
  glm::vec3 fromLocal(const glm::vec3& v) const { return v.x * x + v.y * y + v.z * z; }
};

inline bool sameSide(const glm::vec3& a, const glm::vec3& b) { return a.z * b.z > 0; }

/// Samples a direction around +z with density cos/pi.
inline glm::vec3 cosineHemisphere(const glm::vec2& u) {
  const float radius = std::sqrt(u.x), angle = 2 * kPi * u.y;
  return {radius * std::cos(angle), radius * std::sin(angle), std::sqrt(std::max(1 - u.x, 0.0f))};
}

}  // namespace gluray::render::bsdf
