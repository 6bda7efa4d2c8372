#include "render/lights/form_factor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gluray::render {
namespace {

using Kind = scene::LightSource::Kind;

using std::numbers::pi;
constexpr int kDiscCorners = 32;

/// A convex polygon as seen from the origin.
struct Polygon {
  std::array<glm::dvec3, kDiscCorners + 1> corner;
  int count = 0;
  void add(const glm::dvec3& p) { corner[static_cast<size_t>(count++)] = p; }
  const glm::dvec3& operator[](int i) const { return corner[static_cast<size_t>(i % count)]; }
};

/// Its part above the horizon.
Polygon above(const Polygon& polygon, const glm::dvec3& normal) {
  Polygon out;
  for (int i = 0; i < polygon.count; ++i) {
    const glm::dvec3 &a = polygon[i], &b = polygon[i + 1];
    const double ha = glm::dot(a, normal), hb = glm::dot(b, normal);
    if (ha > 0) out.add(a);
    if ((ha > 0) != (hb > 0)) out.add(a + (b - a) * (ha / (ha - hb)));
  }
  return out;
}

double ofPolygon(const Polygon& polygon, const glm::dvec3& normal) {
  const Polygon seen = above(polygon, normal);
  double sum = 0;
  for (int i = 0; i < seen.count; ++i) {
    const glm::dvec3 across = glm::cross(seen[i], seen[i + 1]);
    const double sine = glm::length(across);
    if (sine > 0) sum += std::atan2(sine, glm::dot(seen[i], seen[i + 1])) * glm::dot(across, normal) / sine;
  }
  return std::abs(sum) / (2 * pi);
}

double ofSphere(const glm::dvec3& toMiddle, double radius, const glm::dvec3& normal) {
  const double distance = glm::length(toMiddle);
  if (!(distance > radius)) return 1;
  const double sine = radius / distance, square = sine * sine,
               cosine = std::clamp(glm::dot(toMiddle, normal) / distance, -1.0, 1.0);
  if (std::abs(cosine) >= sine) return square * std::max(cosine, 0.0);
  const double x = std::sqrt(1 / square - 1), across = std::sqrt(1 - cosine * cosine),
               y = std::clamp(-x * cosine / across, -1.0, 1.0), z = across * std::sqrt(1 - y * y);
  return ((cosine * std::acos(y) - x * z) * square + std::atan2(z, x)) / pi;
}

Polygon polygonOf(const scene::LightSource& light, const glm::dvec3& toMiddle) {
  Polygon p;
  glm::dvec3 x(light.halfEdge[0]), y(light.halfEdge[1]);
  if (light.kind == Kind::rectangle) {
    p.add(toMiddle - x - y), p.add(toMiddle + x - y), p.add(toMiddle + x + y), p.add(toMiddle - x + y);
    return p;
  }
  constexpr double kStep = 2 * pi / kDiscCorners;
  // As large as the disc.
  const double radius = light.radius * std::sqrt(kStep / std::sin(kStep));
  const glm::dvec3 n(light.direction);
  x = glm::normalize(glm::cross(n, std::abs(n.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  y = glm::cross(n, x);
  for (int i = 0; i < kDiscCorners; ++i)
    p.add(toMiddle + radius * (std::cos(i * kStep) * x + std::sin(i * kStep) * y));
  return p;
}

}  // namespace

float formFactor(const scene::LightSource& light, const glm::vec3& point, const glm::vec3& normal) {
  const glm::dvec3 toMiddle = glm::dvec3(light.position) - glm::dvec3(point), n(normal);
  if (light.kind == Kind::sphere)
    return static_cast<float>(std::max(ofSphere(toMiddle, light.radius, n), 0.0));
  if (!(glm::dot(toMiddle, glm::dvec3(light.direction)) < 0)) return 0;
  return static_cast<float>(std::min(ofPolygon(polygonOf(light, toMiddle), n), 1.0));
}

}  // namespace gluray::render
