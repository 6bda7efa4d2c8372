#include "render/integrators/metric.h"

#include "render/remote/remote_surfaces.h"
#include "scene/failure.h"
#include "scene/secondary_scene.h"

#include <cmath>

namespace gluray::render {
namespace {

glm::vec3 axisScales(const glm::dmat4& m) {
  return {glm::length(glm::dvec3(m[0])), glm::length(glm::dvec3(m[1])), glm::length(glm::dvec3(m[2]))};
}

}  // namespace

Metric::Metric(const FrameData& frame) {
  const glm::dmat4& m = frame.snapshot->eyeFromWorld;
  const glm::dmat4 inverse = glm::inverse(m);
  worldFromEye = glm::mat4(inverse), eyeFromWorld = glm::mat4(m);
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r)
      if (!std::isfinite(worldFromEye[c][r]))
        throw scene::Untraceable("the modelview matrix cannot be inverted");
  away = frame.eyeRays.step;
  axes = axisScales(m);
  const accel::Bounds bounds = frame.remote ? frame.remote->bounds() : frame.world->lightBounds();
  const glm::dvec3 size(bounds.upper - bounds.lower);
  const auto* around = frame.snapshot->secondaryScene.get();
  const bool elsewhere = around && around->viewFromWorld != glm::dmat4(1);
  const glm::vec3 sides = elsewhere ? axisScales(m * glm::inverse(around->viewFromWorld)) : axes;
  diagonal = static_cast<float>(glm::length(glm::dvec3(sides) * size));
  if (!frame.remote && frame.snapshot->extent > 0) diagonal = frame.snapshot->extent;
}

}  // namespace gluray::render
