#include "render/effects/feature_integrators.h"

#include "render/effects/surface_light.h"
#include "render/lights/relit.h"
#include "render/paths/path_integrator.h"
#include "scene/effects.h"
#include "scene/failure.h"

#include <algorithm>
#include <cmath>
#include <utility>

#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/effects/feature_integrators.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// What follows is included once for each instruction set, after Highway's macros.
#include "render/integrators/points.inl.h"
#include "render/shading/shade.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

HWY_ATTR void showReflectance(const ReflectanceFeature& integrator, const ColoredHits& hits,
                              ColorRows& rows) {
  LitRows albedo;
  shade(integrator.frame, (*integrator.colors.albedo)[hits.instance], hits.group, hits.back, hits.x, hits.y,
        albedo);
  for (int c = 0; c < 3; ++c) std::copy_n(albedo.value[c], kLanes, rows.value[c]);
}

HWY_ATTR void showGeometry(const GeometryFeatures& integrator, const ColoredHits& hits, ColorRows& rows) {
  SurfacePoints points;
  makePoints(integrator.metric, integrator.frame, hits, points);
  const PixelSpace& space = integrator.space;
  const bool perspective = integrator.perspective;
  const float width = integrator.width;
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const Float3 point = load3(points.eye, i), normal = load3(points.shading, i);
    const Float depth = hn::Add(dot(splat(glm::vec3(space.depth)), point), splat(space.depth.w));
    Float along, distance;
    if (perspective) {
      const Float3 ray = scaled(sub(point, splat(space.base)), hn::Div(splat(1 / width), depth));
      along = dot(normal, ray), distance = depth;
    } else {
      along = hn::Mul(dot(normal, splat(glm::normalize(space.ray))), splat(GeometryFeatures::kFarAway));
      const float pixels = glm::length(space.ray) / width;
      distance = hn::MulAdd(hn::Sub(depth, splat(1)), splat(pixels), splat(GeometryFeatures::kFarAway));
    }
    store(dot(normal, splat(integrator.right)), rows.value[0] + i),
        store(dot(normal, splat(integrator.up)), rows.value[1] + i);
    if (integrator.frame.snapshot->layers) {
      store(distance, rows.value[2] + i);
      continue;
    }
    store(along, rows.value[2] + i), store(distance, rows.value[3] + i);
  }
}

HWY_ATTR void showSurfaces(const SurfaceFeatures& integrator, const ColoredHits& hits, ColorRows& rows) {
  SurfacePoints points;
  makePoints(integrator.metric, integrator.frame, hits, points);
  const bool normals = integrator.frame.snapshot->lightSampling.mode == scene::LightSampling::Mode::surfaces;
  for (int c = 0; c < 3; ++c) std::copy_n(normals ? points.shading[c] : points.eye[c], kLanes, rows.value[c]);
  std::fill_n(rows.value[3], kLanes, static_cast<float>(hits.instance + 1));
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gluray::render {

HWY_EXPORT(showReflectance);
HWY_EXPORT(showGeometry);
HWY_EXPORT(showSurfaces);

void ReflectanceFeature::light(const ColoredHits& hits, ColorRows& rows) const noexcept {
  HWY_DYNAMIC_DISPATCH(showReflectance)(*this, hits, rows);
}

GeometryFeatures::GeometryFeatures(const FrameData& of)
    : frame(of),
      metric(of),
      space(of),
      perspective(space.perDepth > 0),
      width(perspective ? space.perDepth : space.pixel),
      right((perspective ? space.rayX : space.baseX) / width),
      up((perspective ? space.rayY : space.baseY) / width) {
  if (!space.usable) throw scene::Untraceable("the projection has no linear rays");
}

float GeometryFeatures::facing(float a, float b, float x, float y) const noexcept {
  const glm::vec3 ray = perspective ? (space.ray + x * space.rayX + y * space.rayY) / width
                                    : glm::normalize(space.ray) * kFarAway;
  glm::vec3 forward = glm::normalize(glm::cross(right, up));
  if (glm::dot(forward, ray) < 0) forward = -forward;
  const float z = std::sqrt(std::max(1 - a * a - b * b, 0.0f));
  return std::min(glm::dot(a * right + b * up - z * forward, ray), 0.0f);
}

void GeometryFeatures::light(const ColoredHits& hits, ColorRows& rows) const noexcept {
  HWY_DYNAMIC_DISPATCH(showGeometry)(*this, hits, rows);
}

void SurfaceFeatures::light(const ColoredHits& hits, ColorRows& rows) const noexcept {
  HWY_DYNAMIC_DISPATCH(showSurfaces)(*this, hits, rows);
}

using Mode = scene::LightSampling::Mode;

bool wantsFeatures(const scene::Snapshot& snapshot) {
  const Mode mode = snapshot.lightSampling.mode;
  return mode == Mode::reflectance || mode == Mode::geometry || mode == Mode::surfaces ||
         mode == Mode::points || mode == Mode::noiseless;
}

std::unique_ptr<const Integrator> makeFeatureIntegrator(const FrameData& frame) {
  const Mode mode = frame.snapshot->lightSampling.mode;
  if (mode == Mode::geometry) return std::make_unique<GeometryFeatures>(frame);
  if (mode == Mode::surfaces || mode == Mode::points) return std::make_unique<SurfaceFeatures>(frame);
  if (mode == Mode::noiseless) return std::make_unique<NoiselessLight>(frame);
  // The local look lacks light from all sides.
  const bool domed = frame.relit && frame.relit->dome.shines();
  if (domed || scene::wantsPaths(frame.snapshot->settings))
    return std::make_unique<ReflectanceFeature>(frame);
  // Hard shadows are a factor of the look, like its colours: the filter must not blur their edges.
  auto shadowed = std::make_unique<SurfaceLight>(frame, false);
  return shadowed->castsHardShadowsAlone() ? std::move(shadowed) : nullptr;
}

}  // namespace gluray::render
#endif
