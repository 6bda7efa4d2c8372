#include "accel/impostors/impostor_reach.h"

#include <algorithm>
#include <cmath>

namespace gluray::accel {

float roundedUp(double length) {
  constexpr double kSteps = 64;
  if (!(length > 0) || !std::isfinite(length)) return 0;
  return static_cast<float>(std::exp2(std::ceil(std::log2(length * (1 + 1e-4)) * kSteps) / kSteps));
}

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
    largest = std::min(largest, 2.0);  // the triangle's corners
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
