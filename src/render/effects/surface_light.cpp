#include "render/effects/surface_light.h"

#include "base/log.h"
#include "render/effects/relit_look.h"
#include "render/integrators/direct_look.h"
#include "render/integrators/points.h"
#include "render/lights/form_factor.h"
#include "render/lights/relit.h"
#include "scene/effects.h"

#include <algorithm>

namespace gluray::render {
namespace {

bool shows(uint32_t lanes, const ShadowLights::Rows& rows, const Visibility& visibility) {
  for (int row = 0; row < kShadowLights; ++row)
    for (int c = 0; c < 3 && (rows.used >> row & 1); ++c)
      for (int i = 0; i < kLanes; ++i)
        if ((lanes >> i & 1) && visibility.lights[row][c][i] != 1) return true;
  return false;
}

}  // namespace

SurfaceLight::SurfaceLight(const FrameData& frame, bool occludes)
    : frame_(frame),
      metric_(frame),
      occluders_(*frame.snapshot, frame.surfaces),
      lights_(findShadowLights(frame, metric_, scene::wantsShadows(frame.snapshot->settings))) {
  const Settings& settings = frame.snapshot->settings;
  if (frame.relit && frame.relit->dome.shines()) dome_ = &frame.relit->dome;
  hasAreas_ = frame.relit && std::any_of(frame.relit->sources.begin(), frame.relit->sources.end(), isArea);
  if (occludes && scene::wantsOcclusion(settings)) occlusion_.emplace(frame, metric_, occluders_);
  if (!scene::wantsShadows(settings)) return;
  if (!lights_.lights.empty())
    shadows_.emplace(frame, metric_, occluders_, lights_);
  else
    log::once(log::Level::info, "no shadows",
              "shadows are on, but no light casts shadows that are visible to the viewer; add a light, for "
              "instance with lights=headlight+key");
}

bool SurfaceLight::castsHardShadowsAlone() const {
  if (!shadows_ || occlusion_ || dome_ || hasAreas_) return false;
  for (int row = 0; row < static_cast<int>(lights_.lights.size()); ++row)
    if (shadows_->isSampled(row)) return false;
  return true;
}

UsedVisibility SurfaceLight::used() const noexcept {
  const int lights = shadows_ ? static_cast<int>(lights_.lights.size()) : 0;
  return {occlusion_.has_value(), lights, lights > 0 && occluders_.areTranslucent()};
}

void SurfaceLight::estimate(const AskedPoints& asked, Visibility& visibility) const noexcept {
  if (occlusion_) occlusion_->estimate(asked, visibility);
  if (shadows_) shadows_->estimate(asked, visibility);
}

void SurfaceLight::locate(const ColoredHits& hits, AskedPoints& points) const noexcept {
  askedPointsOf(metric_, frame_, hits, points);
}

bool SurfaceLight::replaces(uint32_t instance, uint32_t lanes, const Visibility& visibility) const noexcept {
  const ShadowLights::Rows& used = lights_.rowsOf(instance);
  return isDomed(used) || hasAreas_ || (shadows_ && shows(lanes, used, visibility));
}

std::vector<float> SurfaceLight::meaning() const {
  std::vector<float> numbers;
  // As shares of the scene, so that its size does not matter.
  const auto keep = [&](const glm::vec3& v) { numbers.insert(numbers.end(), {v.x, v.y, v.z}); };
  for (const PlacedLattice& medium : frame_.media) {
    const glm::mat4 worldFromLattice = glm::inverse(medium.latticeFromWorld);
    for (const glm::vec3& corner : {glm::vec3(0), glm::vec3(medium.extinction->size)})
      keep(glm::vec3(worldFromLattice * glm::vec4(corner, 1)) / metric_.diagonal);
    numbers.push_back(medium.extinction->mean);
  }
  return numbers;
}

std::vector<glm::vec3> SurfaceLight::lightPlaces() const {
  std::vector<glm::vec3> places;
  const glm::mat3 linear(metric_.worldFromEye);
  for (const scene::LightSource& light : lights_.lights) {
    if (light.kind != scene::LightSource::Kind::distant)
      places.push_back(glm::vec3(metric_.worldFromEye * glm::vec4(light.position, 1)) / metric_.diagonal);
    places.push_back(glm::normalize(linear * light.direction));
  }
  return places;
}

std::optional<float> SurfaceLight::occlusionAlone() const noexcept {
  if (!occlusion_ || shadows_ || dome_ || hasAreas_ || occlusion_->interreflects) return {};
  return occlusion_->strength;
}

void SurfaceLight::apply(const ColoredHits& hits, const Visibility& visibility,
                         ColorRows& rows) const noexcept {
  const ColorRows* direct = hits.direct;
  ColorRows relitDirect, fog, unshadowed;
  const bool interreflects = occlusion_ && occlusion_->interreflects;
  if (interreflects) unshadowed = rows;
  if (relight(hits, visibility, rows) && occlusion_ && direct) {
    shadeArriving(frame_.direct->surfaces[hits.instance], hits, visibility, nullptr, relitDirect);
    direct = &relitDirect;
  }
  if (!occlusion_) return;
  // Fog lies before the surface. It is in the direct look, too.
  if (!direct && hits.surface.lighting->shading->fog.mode != scene::Fog::off)
    fogAlone(hits, fog), direct = &fog;
  occlude(visibility, direct, interreflects ? &unshadowed : nullptr, rows);
}

bool SurfaceLight::relight(const ColoredHits& hits, const Visibility& visibility, ColorRows& rows) const {
  if (!replaces(hits.instance, hits.group.lanes, visibility)) return false;
  const ShadowLights::Rows& used = lights_.rowsOf(hits.instance);
  shadeArriving(hits.surface, hits, visibility, isDomed(used) ? dome_ : nullptr, rows);
  return true;
}

void SurfaceLight::shadeArriving(const Surface& surface, const ColoredHits& hits,
                                 const Visibility& visibility, const scene::Dome* dome,
                                 ColorRows& rows) const {
  Arrival arrival{lights_.rowsOf(hits.instance), visibility, dome};
  if (!hasAreas_) return shadeAgain(frame_, surface, hits, arrival, rows);
  const Relit& relit = *frame_.relit;
  const AreaLights areas{metric_, relit.sources, relit.firstSource[frame_.shadingOf(hits.instance)]};
  arrival.areas = &areas;
  shadeAgain(frame_, surface, hits, arrival, rows);
}

void SurfaceLight::occlude(const Visibility& visibility, const ColorRows* kept, const ColorRows* reflectance,
                           ColorRows& rows) const {
  for (int c = 0; c < 3; ++c) {
    for (int i = 0; i < kLanes; ++i) {
      const float ambient = rows.value[c][i] - (kept ? kept->value[c][i] : 0);
      float blocked = occlusion_->strength * (1 - visibility.occlusion[i]);
      if (reflectance)
        blocked = 1 - AmbientOcclusion::withReflections(1 - blocked,
                                                        std::clamp(reflectance->value[c][i], 0.0f, 1.0f));
      rows.value[c][i] -= blocked * ambient;
    }
  }
}

}  // namespace gluray::render
