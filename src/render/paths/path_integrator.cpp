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

/// Whether colours are no sums of light: VTK's physically based shading encodes them.
inline bool isEncoded(const ColoredHits& hits) {
  return hits.surface.lighting->shading->fragment.model == scene::FragmentShading::Model::pbr;
}

/// Replaces the colours of the local look by the paths' mean.
HWY_ATTR inline void finishColors(const ColoredHits& hits, const glm::vec3 (&means)[kLanes],
                                  ColorRows& rows) {
  const scene::Shading& shading = *hits.surface.lighting->shading;
  const bool encoded = isEncoded(hits);
  LitRows colors;
  for (int i = 0; i < kLanes; ++i) {
    glm::vec3 mean = means[i];
    // VTK's physically based shading ends with this encoding, as the local look does.
    if (encoded) mean = glm::pow(mean, glm::vec3(1 / 2.2f));
    for (int c = 0; c < 3; ++c) colors.value[c][i] = mean[c];
  }
  if (shading.fog.mode != scene::Fog::off) applyFog(hits.surface, hits.group, colors);
  for (int c = 0; c < 3; ++c) std::copy_n(colors.value[c], kLanes, rows.value[c]);
}

/// Where the paths of a packet begin.
struct Start {
  PathVertices camera;
  alignas(64) Row from[3];  // back to the viewer
  RayCone cones[kLanes];    // if textures are filtered
  HWY_ATTR Start(const Path& path, const ColoredHits& hits) {
    cameraVertices(path, hits, from, camera);
    for (int i = 0; i < kLanes && path.filters; ++i)
      cones[i] = coneAt(path.frame.eyeRays, double{hits.x[i]}, double{hits.y[i]}, camera.lane[i].point);
  }
};

/// `alone`: paths meet no other surface.
HWY_ATTR void lightByPaths(const Path& path, const ColoredHits& hits, bool alone, ColorRows& rows) {
  const Start start(path, hits);
  const PixelSeeds seeds(hits.x, hits.y);
  const int samples = partOf(path.samples, hits.share);
  const uint32_t first = path.frame.firstLightSample(hits.sample, samples);
  glm::vec3 sum[kLanes] = {};
  for (int s = 0; s < samples; ++s) {
    Wave wave(path, hits, seeds, first + static_cast<uint32_t>(s), start.camera, start.from, start.cones,
              alone);
    wave.run();
    for (int i = 0; i < kLanes; ++i) sum[i] += wave.radiance(i);
  }
  const float perPath = 1 / static_cast<float>(samples);
  for (glm::vec3& color : sum) color *= perPath;
  finishColors(hits, sum, rows);
}

HWY_ATTR void lightWithoutNoise(const Path& path, const ColoredHits& hits, ColorRows& rows) {
  glm::vec3 light[kLanes];
  if (isEncoded(hits)) {
    for (int c = 0; c < 3; ++c) std::fill_n(rows.value[c], kLanes, 0.0f);
    return;
  }
  const Start start(path, hits);
  const PixelSeeds seeds(hits.x, hits.y);
  Wave wave(path, hits, seeds, 0, start.camera, start.from, start.cones, false);
  wave.lightWithoutNoise();
  for (int i = 0; i < kLanes; ++i) light[i] = wave.radiance(i);
  finishColors(hits, light, rows);
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gluray::render {

HWY_EXPORT(lightByPaths);
HWY_EXPORT(lightWithoutNoise);

void PathIntegrator::light(const ColoredHits& hits, ColorRows& rows) const noexcept {
  HWY_DYNAMIC_DISPATCH(lightByPaths)(path_, hits, false, rows);
}

void PathIntegrator::lightAlone(const ColoredHits& hits, ColorRows& rows) const noexcept {
  HWY_DYNAMIC_DISPATCH(lightByPaths)(path_, hits, true, rows);
}

void NoiselessLight::light(const ColoredHits& hits, ColorRows& rows) const noexcept {
  HWY_DYNAMIC_DISPATCH(lightWithoutNoise)(path_, hits, rows);
}

}  // namespace gluray::render
#endif
