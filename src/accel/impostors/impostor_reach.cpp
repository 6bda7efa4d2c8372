#include "accel/impostors/impostor_reach.h"

#include <algorithm>
#include <cmath>

namespace gluray::accel {

float roundedUp(double length) {
  constexpr double kSteps = 64;
  if (!(length > 0) || !std::isfinite(length)) return 0;
  return static_cast<float>(std::exp2(std::ceil(std::log2(length * (1 + 1e-4)) * kSteps) / kSteps));
}

namespace {

/// The largest slope of lines of sight against the z axis of lighting space.
double slopeOfSight(const scene::Instance& instance, const scene::Camera& camera) {
  const glm::dmat4 lightingFromClip = glm::dmat4(instance.lightingFromObject) *
                                      glm::inverse(instance.eyeFromObject) * glm::inverse(camera.clipFromEye);
  double most = 0;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0}) {
      const glm::dvec4 near = lightingFromClip * glm::dvec4(x, y, -1, 1), step = lightingFromClip[2];
      const glm::dvec3 way = glm::dvec3(step) * near.w - step.w * glm::dvec3(near);
      most = std::max(most, std::hypot(way.x, way.y) / std::abs(way.z));
    }
  return std::isfinite(most) ? most : 0;
}

}  // namespace

ImpostorReach reachOf(const scene::Instance& instance, const scene::Camera& camera) {
  const bool pixels = scene::isSolid(instance.mesh->shape) && instance.impostors.radius == 0;
  if (scene::isSizedInPixels(instance.mesh->shape) || pixels) return reachInPixels(instance, camera);
  if (instance.mesh->shape == scene::Shape::splats) return reachOfSplats(instance, camera);
  ImpostorReach reach;
  const glm::dmat3 objectFromLighting = glm::inverse(glm::dmat3(glm::mat3(instance.lightingFromObject)));
  // The extent of |M p| <= r along an axis is r times the length of that row of M's inverse.
  const glm::dmat3 rows = glm::transpose(objectFromLighting);
  double largest = 1 / double{instance.impostors.radiusDivisor};
  if (instance.impostors.billboards == scene::Impostors::Billboards::triangle)
    largest = instance.impostors.gaussian ? 2.0 : std::min(largest, 2.0);  // the triangle's corners
  // Depths of a half sphere lie on lines of sight through its disc, a radius further at most along z.
  if (instance.impostors.hemispheres) largest *= 1 + slopeOfSight(instance, camera);
  if (scene::isSolid(instance.mesh->shape)) largest = double{instance.impostors.radius};
  for (int c = 0; c < 3; ++c) reach.perRadius[c] = roundedUp(glm::length(rows[c]) * largest);
  if (instance.mesh->shape != scene::Shape::cylinders) return reach;
  const glm::dmat3 axes = objectFromLighting * glm::dmat3(instance.impostors.axisMatrix);
  double most = 0;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) most = std::max(most, std::abs(axes[c][r]));
  const double step = std::exp2(std::ceil(std::log2(std::max(most, 1e-30) * (1 + 1e-4))) - 10);
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r)
      reach.alongAxis[c][r] = static_cast<float>(std::round(axes[c][r] / step) * step);
  reach.perLength = glm::vec3(static_cast<float>(step));
  return reach;
}

}  // namespace gluray::accel
