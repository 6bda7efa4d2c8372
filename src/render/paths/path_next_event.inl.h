// Light that reaches the vertices of paths straight from lights and the environment. Compiled once for each
// instruction set.
#if defined(GLURAY_RENDER_PATHS_PATH_NEXT_EVENT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_PATHS_PATH_NEXT_EVENT_INL_H_
#undef GLURAY_RENDER_PATHS_PATH_NEXT_EVENT_INL_H_
#else
#define GLURAY_RENDER_PATHS_PATH_NEXT_EVENT_INL_H_
#endif

#include "render/paths/path_wave.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// One light for each path, chosen by what all of them would give if nothing were in their way.
HWY_ATTR inline void Wave::sampleLights() {
  alignas(64) Row u, unused;
  draw(PathUse::light, u, unused);
  accel::OcclusionRays rays;
  uint32_t lanes = 0;
  glm::vec3 brought[kLanes];
  eachLane([&](int i) {
    const PathVertex& v = vertices_.lane[i];
    const bsdf::LocalFrame local(v.shading);
    const glm::vec3 wo = local.toLocal(back_[i]);
    const bsdf::Any material = path_.bsdfOf(v, isInside(i));
    const float irradiance = path_.irradianceOfOne(v) * path_.lightScale;
    float total = 0;
    ArrivingLight chosen;
    float share = 0, rest = u[i];
    for (uint32_t l = 0; l < path_.lights.countOf(v.instance); ++l) {
      const ArrivingLight light = path_.lights.at(v.instance, l, v.point);
      glm::vec3 value =
          bsdf::evaluate(material, wo, local.toLocal(light.direction)) * light.color * irradiance;
      if (v.specular != glm::vec3(0))
        value += path_.lightScale * v.specular *
                 path_.lights.highlight(v.instance, l, light, v.shading, viewerOf(i), v.shininess);
      const float weight = value.x + value.y + value.z;
      if (!(weight > 0) || !std::isfinite(weight)) continue;
      // Weighted reservoir of one, by a single random number.
      total += weight;
      const float keep = weight / total;
      if (rest < keep) {
        chosen = light, brought[i] = value, share = weight;
        rest /= keep;
      } else {
        rest = (rest - keep) / (1 - keep);
      }
    }
    if (!(total > 0)) return;
    brought[i] *= total / share;
    if (depth_ == 0 && chosen.atViewer) return add(i, brought[i]);
    constexpr float kBefore = 1 - 1e-5f;
    aim(rays, i, chosen.direction, chosen.distance * kBefore);
    lanes |= 1u << i;
  });
  if (!lanes) return;
  float through[kLanes];
  transmitFromLights(lanes, rays, through);
  for (; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    if (through[i] > 0) add(i, brought[i] * through[i]);
  }
}

HWY_ATTR inline void Wave::sampleEnvironment() {
  alignas(64) Row u, v;
  draw(PathUse::environment, u, v);
  accel::OcclusionRays rays;
  uint32_t lanes = 0;
  glm::vec3 brought[kLanes];
  eachLane([&](int i) {
    const PathVertex& at = vertices_.lane[i];
    const Environment::Arriving sky = path_.environment->sample({u[i], v[i]});
    if (!(sky.pdf > 0)) return;
    const bsdf::LocalFrame local(at.shading);
    const glm::vec3 wo = local.toLocal(back_[i]), wi = local.toLocal(sky.direction);
    const bsdf::Any material = path_.bsdfOf(at, isInside(i));
    const glm::vec3 value = bsdf::evaluate(material, wo, wi);
    if (!(largestOf(value) > 0)) return;
    brought[i] = value * sky.radiance * (powerHeuristic(sky.pdf, bsdf::pdf(material, wo, wi)) / sky.pdf);
    aim(rays, i, sky.direction, std::numeric_limits<float>::infinity());
    lanes |= 1u << i;
  });
  if (!lanes) return;
  float through[kLanes];
  transmit(lanes, rays, through);
  for (; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    if (through[i] > 0) add(i, brought[i] * through[i]);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
