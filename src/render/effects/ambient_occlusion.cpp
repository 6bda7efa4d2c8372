#include "render/effects/ambient_occlusion.h"

#include "render/effects/first_sample.h"
#include "render/remote/remote_surfaces.h"

#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/effects/ambient_occlusion.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// What follows is included once for each instruction set, after Highway's macros.
#include "render/integrators/points.inl.h"
#include "render/sampling/sobol.inl.h"
#include "render/sampling/warp.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// Rays of sample `index` into the hemispheres above the points.
HWY_ATTR inline void aimAbove(const AmbientOcclusion& ao, const SurfacePoints& points,
                              const PixelSeeds& seeds, uint32_t index, accel::OcclusionRays& rays) {
  const glm::mat3 worldFromEye(ao.metric.worldFromEye);
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const Float3 flat = load3(points.geometric, i), normal = load3(points.shading, i);
    const Sample2 sample = sample2(seeds, i, index, Dimensions::ambientOcclusion);
    const Float3 eye = reflectedAbove(flat, aboveSurface(normal, cosineHemisphere(sample)));
    const Float3 world = transform(worldFromEye, eye);
    store(load(points.origin[0] + i), rays.orgX + i), store(load(points.origin[1] + i), rays.orgY + i),
        store(load(points.origin[2] + i), rays.orgZ + i);
    store(world.x, rays.dirX + i), store(world.y, rays.dirY + i), store(world.z, rays.dirZ + i);
    store(hn::Zero(FloatTag()), rays.tNear + i);
    store(splat(ao.radius), rays.tFar + i);
  }
}

HWY_ATTR void occlude(const AmbientOcclusion& ao, const AskedPoints& asked, float* occlusion) {
  const PixelSeeds seeds = seedsOf(ao.frame, asked);
  const int samples = partOf(ao.samples, asked.share);
  const uint32_t first = firstSample(ao.frame, asked.sample, samples);
  alignas(64) int32_t valid[kLanes];
  for (int i = 0; i < kLanes; ++i) valid[i] = asked.lanes >> i & 1 ? -1 : 0;
  float hidden[kLanes] = {};
  accel::OcclusionRays rays;
  for (int s = 0; s < samples; ++s) {
    aimAbove(ao, asked.points, seeds, first + static_cast<uint32_t>(s), rays);
    const Transmittance light(ao.occluders);
    const uint32_t blocked =
        occludedAnywhere(ao.frame, valid, rays, accel::RayKind::occlusion,
                         ao.occluders.areSolid() ? nullptr : &light, {.grey = light.through});
    for (int i = 0; i < kLanes; ++i) hidden[i] += blocked >> i & 1 ? 1 : 1 - light.through[i];
  }
  const float perRay = 1 / static_cast<float>(samples);
  for (int i = 0; i < kLanes; ++i) occlusion[i] = 1 - perRay * hidden[i];
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gluray::render {

HWY_EXPORT(occlude);

AmbientOcclusion::AmbientOcclusion(const FrameData& of, const Metric& m, const Occluders& o)
    : frame(of),
      metric(m),
      occluders(o),
      samples(samplesOf(of, of.snapshot->settings.ao.samples)),
      radius(of.snapshot->settings.ao.distance > 0 ? of.snapshot->settings.ao.distance
                                                   : of.snapshot->settings.ao.radius * metric.diagonal),
      strength(of.snapshot->settings.ao.strength),
      interreflects(of.snapshot->settings.ao.interreflection) {}

void AmbientOcclusion::estimate(const AskedPoints& asked, Visibility& visibility) const noexcept {
  HWY_DYNAMIC_DISPATCH(occlude)(*this, asked, visibility.occlusion);
}

}  // namespace gluray::render
#endif
