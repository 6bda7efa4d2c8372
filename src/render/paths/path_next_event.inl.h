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

inline void Wave::litBy(int i, const bsdf::Any& material) {
  const PathVertex& v = vertices_.lane[i];
  LitPoint& at = lit_[i];
  at.point = v.point, at.normal = v.shading;
  at.sided =
      std::holds_alternative<bsdf::Lambert>(material) || std::holds_alternative<bsdf::OrenNayar>(material);
  at.factor = path_.irradianceOfOne(v) * path_.lightScale * bsdf::kInversePi;
  // Coats reflect whatever the colour of what they cover.
  const glm::vec3 share = v.albedo + v.specular + glm::vec3(at.sided ? 0.0f : 0.05f);
  at.reflected = share * (at.factor * bsdf::kInversePi);
}

inline glm::vec3 Wave::bringAdded(int i, const bsdf::Any& material, size_t light, float chance,
                                  const glm::vec2& u, ArrivingLight& out) const {
  const PathVertex& v = vertices_.lane[i];
  const LightShape::Arriving a = path_.added[light].sample(v.point, u);
  out.direction = a.direction, out.distance = a.distance;
  if (a.irradiance == glm::vec3(0)) return glm::vec3(0);
  const bsdf::LocalFrame local(v.shading);
  const glm::vec3 wo = local.toLocal(back_[i]), wi = local.toLocal(a.direction);
  glm::vec3 reflected = bsdf::evaluate(material, wo, wi);
  if (a.pdf > 0 && path_.added.isMet(light))
    reflected *= powerHeuristic(chance * a.pdf, bsdf::pdf(material, wo, wi));
  // Highlights of the program's equation are those of lights: paths that meet a light bring none.
  if (v.specular != glm::vec3(0))
    reflected += v.specular * (bsdf::kInversePi * path_.lights.highlight(v.instance, a.direction, v.shading,
                                                                         viewerOf(i), v.shininess));
  return reflected * a.irradiance * (lit_[i].factor / chance);
}

inline bool Wave::meetLights(int i, float from, float to) {
  const bool exact = !(pdf_[i] > 0);
  const LitPoint& at = lit_[i];
  float nearest = std::numeric_limits<float>::infinity();
  const LightShape* shown = nullptr;
  for (size_t l = 0; l < path_.added.size(); ++l) {
    const LightShape& light = path_.added[l];
    if (exact ? !light.isVisible() : !path_.added.isMet(l)) continue;
    const auto met = light.meet(glm::dvec3(at.point), glm::dvec3(way_[i]));
    if (!met || !(met->distance > from && met->distance <= to)) continue;
    if (exact) {
      if (!shown || met->distance < nearest) nearest = met->distance, shown = &light;
      continue;
    }
    const float chance = at.total > 0 ? weightOf(at, l) / at.total : 0;
    add(i, absorbed(i, met->distance - from) * met->radiance *
               (at.factor * powerHeuristic(pdf_[i], chance * met->pdf)));
  }
  if (!shown) return false;
  // Mirrors and clear glass show the light as the viewer would see it.
  add(i, absorbed(i, nearest - from) * shown->shown() * path_.lightScale);
  return true;
}

inline glm::vec3 Wave::reflectedOf(int i, uint32_t l, const ArrivingLight& light, const bsdf::Any& material,
                                   const bsdf::LocalFrame& local, const glm::vec3& wo) const {
  const PathVertex& v = vertices_.lane[i];
  const float irradiance = path_.irradianceOfOne(v) * path_.lightScale;
  glm::vec3 value = bsdf::evaluate(material, wo, local.toLocal(light.direction)) * light.color * irradiance;
  if (v.specular != glm::vec3(0))
    value += path_.lightScale * v.specular *
             path_.lights.highlight(v.instance, l, light, v.shading, viewerOf(i), v.shininess);
  return value;
}

/// One light for each path, chosen by what all of them would give if nothing were in their way.
HWY_ATTR inline void Wave::sampleLights() {
  alignas(64) Row u, unused, onLightX, onLightY;
  draw(PathUse::light, u, unused);
  if (!path_.added.empty())
    drawFrom(static_cast<uint32_t>(Dimensions::addedLights) + static_cast<uint32_t>(depth_), onLightX,
             onLightY);
  accel::OcclusionRays rays, opaqueRays;
  uint32_t lanes = 0, opaque = 0;  // opaque: of lights that paths find behind glass
  glm::vec3 brought[kLanes];
  eachLane([&](int i) {
    const PathVertex& v = vertices_.lane[i];
    const bsdf::LocalFrame local(v.shading);
    const glm::vec3 wo = local.toLocal(back_[i]);
    const bsdf::Any material = path_.bsdfOf(v, isInside(i));
    WeightedChoice choice{u[i]};
    ArrivingLight chosen;
    for (uint32_t l = 0; l < path_.lights.countOf(v.instance); ++l) {
      const ArrivingLight light = path_.lights.at(v.instance, l, v.point);
      const glm::vec3 value = reflectedOf(i, l, light, material, local, wo);
      if (choice.takes(value.x + value.y + value.z)) chosen = light, brought[i] = value;
    }
    size_t added = path_.added.size();
    if (!path_.added.empty()) {
      litBy(i, material);
      for (size_t l = 0; l < path_.added.size(); ++l)
        if (choice.takes(weightOf(lit_[i], l))) added = l;
      lit_[i].total = choice.total;
    }
    if (!(choice.total > 0)) return;
    if (added < path_.added.size()) {
      chosen = {};
      brought[i] =
          bringAdded(i, material, added, choice.share / choice.total, {onLightX[i], onLightY[i]}, chosen);
      if (!(largestOf(brought[i]) > 0)) return;
    } else {
      brought[i] *= choice.total / choice.share;
    }
    if (depth_ == 0 && chosen.atViewer) return add(i, brought[i]);
    if (added < path_.added.size() && path_.added.isMet(added) && path_.added[added].isVisible()) {
      aim(opaqueRays, i, chosen.direction, chosen.distance * kBeforeLight);
      opaque |= 1u << i;
    } else {
      aim(rays, i, chosen.direction, chosen.distance * kBeforeLight);
      lanes |= 1u << i;
    }
  });
  float through[kLanes];
  if (lanes) transmitFromLights(lanes, rays, through), bring(lanes, brought, through);
  if (opaque) transmit(opaque, opaqueRays, through), bring(opaque, brought, through);
}

/// All of the program's lights. The vertices are of one instance, which viewers see.
HWY_ATTR inline void Wave::sampleEachLight() {
  uint32_t count = 0;
  eachLane([&](int i) { count = std::max(count, path_.lights.countOf(vertices_.lane[i].instance)); });
  for (uint32_t l = 0; l < count; ++l) {
    accel::OcclusionRays rays;
    uint32_t lanes = 0;
    glm::vec3 brought[kLanes];
    eachLane([&](int i) {
      const PathVertex& v = vertices_.lane[i];
      const bsdf::LocalFrame local(v.shading);
      const ArrivingLight light = path_.lights.at(v.instance, l, v.point);
      brought[i] = reflectedOf(i, l, light, path_.bsdfOf(v, isInside(i)), local, local.toLocal(back_[i]));
      if (!(largestOf(brought[i]) > 0)) return;
      if (light.atViewer) return add(i, brought[i]);
      aim(rays, i, light.direction, light.distance * kBeforeLight);
      lanes |= 1u << i;
    });
    if (!lanes) continue;
    float through[kLanes];
    transmitFromLights(lanes, rays, through);
    bring(lanes, brought, through);
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
  bring(lanes, brought, through);
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
