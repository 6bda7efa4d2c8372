#include "render/lights/lamps.h"

#include "render/lights/relit.h"
#include "scene/effects.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gluray::render {
namespace {

// Depth of what lies beyond the far plane: in front of what framebuffers are cleared to.
constexpr float kBeyond = 1 - 0x1p-22f;

}  // namespace

Lamps::Lamps(const scene::Snapshot& snapshot, const Relit& relit, const RaySetup& eyeRays,
             const DepthMap& depth)
    : snapshot_(snapshot), eyeRays_(eyeRays), depth_(depth) {
  const Settings& s = snapshot.settings;
  factor_ = scene::wantsPaths(s) ? s.path.lights : 1;
  for (const scene::LightSource& light : relit.sources)
    if (light.visible) shapes_.emplace_back(light, 0.0f);
}

std::unique_ptr<const Lamps> makeLamps(const scene::Snapshot& snapshot, const Relit& relit,
                                       const RaySetup& eyeRays, const DepthMap& depth) {
  if (snapshot.layers) return nullptr;
  const auto& sources = relit.sources;
  const auto visible = [](const scene::LightSource& l) { return l.visible; };
  const auto& shadings = snapshot.shadings;
  if (std::none_of(sources.begin(), sources.end(), visible)) return nullptr;
  if (std::none_of(shadings.begin(), shadings.end(), scene::isLit)) return nullptr;
  return std::make_unique<Lamps>(snapshot, relit, eyeRays, depth);
}

EyeRay Lamps::rayOf(const accel::RayPacket& rays, int i) const {
  const glm::dmat4& eyeFromWorld = snapshot_.eyeFromWorld;
  const glm::dvec3 org(eyeFromWorld * glm::dvec4(rays.orgX[i], rays.orgY[i], rays.orgZ[i], 1));
  return {org,
          glm::normalize(glm::dmat3(eyeFromWorld) * glm::dvec3(rays.dirX[i], rays.dirY[i], rays.dirZ[i]))};
}

float Lamps::depthAt(const glm::dvec3& point) const {
  const glm::dvec4 clip = snapshot_.camera.clipFromEye * glm::dvec4(point, 1);
  const double depth = depth_.scale * (clip.z / clip.w) + depth_.offset;
  if (!std::isfinite(depth)) return kBeyond;
  return static_cast<float>(std::clamp(depth, 0.0, double{kBeyond}));
}

uint32_t Lamps::show(const float* x, const float* y, const accel::RayPacket* rays, Row& depth,
                     ColorRows& rows) const noexcept {
  uint32_t lanes = 0;
  for (int i = 0; i < kLanes; ++i) {
    const EyeRay ray = rays ? rayOf(*rays, i) : eyeRayAt(eyeRays_, double{x[i]}, double{y[i]});
    float nearest = std::numeric_limits<float>::infinity();
    for (const LightShape& shape : shapes_) {
      const auto met = shape.meet(ray.origin, ray.direction);
      if (!met || (nearest < met->distance)) continue;
      nearest = met->distance;
      const float at =
          std::isfinite(nearest) ? depthAt(ray.origin + double{nearest} * ray.direction) : kBeyond;
      if (!(at < depth[i]) && !(lanes >> i & 1)) continue;
      depth[i] = at, lanes |= 1u << i;
      const glm::vec3 color = factor_ * shape.shown();
      for (int c = 0; c < 3; ++c) rows.value[c][i] = color[c];
    }
  }
  for (int i = 0; i < kLanes; ++i) rows.value[3][i] = 1;
  for (int c = 4; c < 7; ++c) std::fill_n(rows.value[c], kLanes, 0.0f);
  return lanes;
}

}  // namespace gluray::render
