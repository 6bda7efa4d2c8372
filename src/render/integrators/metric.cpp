#include "render/integrators/metric.h"

#include <cmath>
#include <stdexcept>

namespace gluray::render {

Metric::Metric(const FrameData& frame) {
  const glm::dmat4& m = frame.snapshot->eyeFromWorld;
  const glm::dmat4 inverse = glm::inverse(m);
  worldFromEye = glm::mat4(inverse), eyeFromWorld = glm::mat4(m);
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r)
      if (!std::isfinite(worldFromEye[c][r]))
        throw std::runtime_error("the modelview matrix cannot be inverted");
  away = frame.eyeRays.step;
  const glm::dvec3 size(frame.world->upper() - frame.world->lower());
  axes = {glm::length(glm::dvec3(m[0])), glm::length(glm::dvec3(m[1])), glm::length(glm::dvec3(m[2]))};
  diagonal = static_cast<float>(glm::length(glm::dvec3(axes) * size));
}

}  // namespace gluray::render
