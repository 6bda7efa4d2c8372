#include "render/paths/ray_cone.h"

#include "render/camera/eye_ray.h"

#include <algorithm>
#include <cmath>

namespace gluray::render {

RayCone coneAt(const RaySetup& eyeRays, double x, double y, const glm::vec3& point) {
  const EyeRay ray = eyeRayAt(eyeRays, x, y);
  const double distance = glm::length(glm::dvec3(point) - ray.origin);
  double aside = 0, apart = 0;
  for (const EyeRay& next : {eyeRayAt(eyeRays, x + 1, y), eyeRayAt(eyeRays, x, y + 1)}) {
    const glm::dvec3 way = next.origin - ray.origin;
    aside = std::max(aside, glm::length(way - glm::dot(way, ray.direction) * ray.direction));
    apart = std::max(apart, glm::length(next.direction - ray.direction));
  }
  return {static_cast<float>(aside + apart * distance), static_cast<float>(apart)};
}

RayCone scattered(const RayCone& cone, float pdf, int samples) {
  constexpr float kMax = 0.2f;
  const float share = std::sqrt(1 / (std::max(pdf, 1e-6f) * static_cast<float>(std::max(samples, 1))));
  return {cone.width, std::max(cone.spread, std::min(share, kMax))};
}

WeightSteps stepsOn(const glm::dvec3 (&corner)[3], const glm::dvec3& way, double width) {
  constexpr double kGrazing = 1e-3;  // cosine
  const glm::dvec3 a = corner[1] - corner[0], b = corner[2] - corner[0], normal = glm::cross(a, b);
  const double square = glm::dot(normal, normal);
  if (!(square > 0)) return {};
  const glm::dvec3 n = normal / std::sqrt(square);
  const double cosine = std::max(std::abs(glm::dot(way, n)), kGrazing);
  glm::dvec3 along = way - glm::dot(way, n) * n;
  const double slant = glm::length(along);
  along = slant > kGrazing ? along / slant : glm::normalize(a);
  const auto weights = [&](const glm::dvec3& step) {
    const double u = glm::dot(glm::cross(step, b), normal) / square,
                 v = glm::dot(glm::cross(a, step), normal) / square;
    return glm::dvec3(-u - v, u, v);
  };
  return {weights(along * (width / cosine)), weights(glm::cross(n, along) * width)};
}

}  // namespace gluray::render
