#include "render/paths/path_integrator.h"

#include <algorithm>

#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/paths/path_integrator.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// What follows is included once for each instruction set, after Highway's macros.
#include "render/paths/path_extension.inl.h"
#include "render/paths/path_next_event.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// `alone`: paths meet no other surface.
HWY_ATTR void lightByPaths(const Path& path, const ColoredHits& hits, bool alone, ColorRows& rows) {
  PathVertices camera;
  alignas(64) Row from[3];
  cameraVertices(path, hits, from, camera);
  RayCone cones[kLanes];
  for (int i = 0; i < kLanes && path.filters; ++i)
    cones[i] = coneAt(path.frame.eyeRays, double{hits.x[i]}, double{hits.y[i]}, camera.lane[i].point);
  const PixelSeeds seeds(hits.x, hits.y);
  const int samples = partOf(path.samples, hits.share);
  const uint32_t first = path.frame.firstLightSample(hits.sample, samples);
  glm::vec3 sum[kLanes] = {};
  for (int s = 0; s < samples; ++s) {
    Wave wave(path, hits, seeds, first + static_cast<uint32_t>(s), camera, from, cones, alone);
    wave.run();
    for (int i = 0; i < kLanes; ++i) sum[i] += wave.radiance(i);
  }
  const float perPath = 1 / static_cast<float>(samples);
  for (glm::vec3& color : sum) color *= perPath;
  finishColors(hits, sum, rows);
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gluray::render {

HWY_EXPORT(lightByPaths);

void PathIntegrator::light(const ColoredHits& hits, ColorRows& rows) const noexcept {
  HWY_DYNAMIC_DISPATCH(lightByPaths)(path_, hits, false, rows);
}

void PathIntegrator::lightAlone(const ColoredHits& hits, ColorRows& rows) const noexcept {
  HWY_DYNAMIC_DISPATCH(lightByPaths)(path_, hits, true, rows);
}

}  // namespace gluray::render
#endif
