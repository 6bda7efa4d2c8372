#include "render/integrators/metric.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace gluray::render {

Metric::Metric(const FrameData& frame) {
  const glm::dmat4& m = frame.snapshot->eyeFromWorld;
  const glm::dmat4 inverse = glm::inverse(m);
  worldFromEye = glm::mat4(inverse);
  eyeFromWorld = glm::mat4(m);
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r)
      if (!std::isfinite(worldFromEye[c][r]))
        throw std::runtime_error("the modelview matrix cannot be inverted");
  away = frame.eyeRays.step;
  const glm::dvec3 size(frame.world->upper() - frame.world->lower());
  double most = 0, sum = 0;
  for (int c = 0; c < 3; ++c) {
    const glm::dvec3 axis(m[c]);
    most = std::max(most, glm::length(axis));
    sum += glm::dot(axis, axis) * size[c] * size[c];
  }
  // Axes of unequal length may add up in the direction between them.
  stretch = static_cast<float>(most * std::sqrt(3.0));
  diagonal = static_cast<float>(std::sqrt(sum));
}

}  // namespace gluray::render
