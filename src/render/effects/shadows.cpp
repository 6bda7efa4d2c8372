#include "render/effects/shadows.h"

#include "render/effects/first_sample.h"
#include "render/lights/relit.h"
#include "render/remote/remote_surfaces.h"

#include <bit>

#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/effects/shadows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// What follows is included once for each instruction set, after Highway's macros.
#include "render/effects/light_samples.inl.h"
#include "render/integrators/points.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// What the dome sends along w, the directions towards it: the mean of the channels.
HWY_INLINE Float domeAt(const scene::Dome& dome, const Float3& w) {
  const auto mean = [](const glm::vec3& v) { return (v.x + v.y + v.z) / 3; };
  const auto above = hn::Gt(dot(w, splat(dome.up)), splat(0));
  return hn::IfThenElse(above, splat(mean(dome.sky)), splat(mean(dome.ground)));
}

/// What a ray brings that grazes the triangle, whose smooth normal faces the light more than the triangle
/// does: shadows of triangles do not end at once where these turn away. Surfaces that bulge over their
/// triangles cast no such shadow.
HWY_INLINE Float grazing(const SurfacePoints& points, int i, const Float3& direction, Float cosine) {
  constexpr float kFrom = 0.15f;  // cosine to the triangle
  const Float flat = dot(load3(points.geometric, i), direction);
  const Float whole = hn::Min(hn::Max(cosine, splat(1e-6f)), splat(kFrom));
  const Float x = clamp01(hn::Div(flat, whole));
  const Float smooth = hn::Mul(hn::Mul(x, x), hn::NegMulAdd(splat(2), x, splat(3)));
  return hn::IfThenElse(hn::Gt(load(points.lift + i), splat(0)), splat(1), smooth);
}

/// Samples of a light at each lane: the rays, what may arrive along them, and what does past the surface.
struct LightSamples {
  accel::OcclusionRays rays;
  alignas(64) Row weights, grazing;
};

/// Sample `index` of a light: fills rays and the weights of what arrives along them.
HWY_ATTR inline void aimAtLight(const Shadows& s, int row, const SurfacePoints& points,
                                const PixelSeeds& seeds, uint32_t index, LightSamples& out) {
  accel::OcclusionRays& rays = out.rays;
  const glm::mat3 worldFromEye(s.metric.worldFromEye);
  const auto use =
      static_cast<Dimensions>(static_cast<uint32_t>(Dimensions::shadows) + static_cast<uint32_t>(row));
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const Float3 normal = load3(points.shading, i);
    const Sample2 sample = sample2(seeds, i, index, use);
    TowardsLight towards;
    Float past = splat(1);
    if (row == s.lights.dome) {
      const Float3 w =
          reflectedAbove(load3(points.geometric, i), aboveSurface(normal, cosineHemisphere(sample)));
      towards = {w, splat(std::numeric_limits<float>::infinity()), domeAt(s.frame.relit->dome, w)};
    } else {
      const scene::LightSource& light = s.lights.lights[static_cast<size_t>(row)];
      towards = towardsLight(light, s.size, load3(points.eye, i), sample);
      const auto turned = hn::Gt(load(points.turned + i), hn::Zero(FloatTag()));
      const Float ahead = dot(normal, towards.direction);
      const Float cosine = hn::Max(hn::IfThenElse(turned, hn::Neg(ahead), ahead), hn::Zero(FloatTag()));
      towards.weight = hn::Mul(towards.weight, cosine);
      past = hn::IfThenElse(turned, splat(1), grazing(points, i, towards.direction, cosine));
    }
    const Float3 world = transform(worldFromEye, towards.direction);
    store(load(points.origin[0] + i), rays.orgX + i), store(load(points.origin[1] + i), rays.orgY + i),
        store(load(points.origin[2] + i), rays.orgZ + i);
    store(world.x, rays.dirX + i), store(world.y, rays.dirY + i), store(world.z, rays.dirZ + i);
    store(hn::Zero(FloatTag()), rays.tNear + i);
    store(towards.distance, rays.tFar + i);
    store(towards.weight, out.weights + i);
    store(past, out.grazing + i);
  }
}

/// Where a light is that something may stand for, which does not hide it; null: there is no such place.
const glm::vec3* lampOf(const Shadows& s, int row) {
  using Kind = scene::LightSource::Kind;
  const scene::LightSource& light = s.lights.lights[static_cast<size_t>(row)];
  return row != s.lights.dome && (light.kind == Kind::point || light.kind == Kind::spot) ? &light.position
                                                                                         : nullptr;
}

/// Adds what arrives along one packet's rays. Where a program lights a surface from its far side, that
/// surface does not block the light.
HWY_ATTR inline void addArriving(const Shadows& s, int row, const AskedPoints& asked, uint32_t lanes,
                                 LightSamples& samples, Row (&sums)[3], Row& all) {
  alignas(64) int32_t valid[kLanes];
  bool anyTurned = false;
  for (int i = 0; i < kLanes; ++i) {
    valid[i] = (lanes >> i & 1) && samples.weights[i] * samples.grazing[i] > 0 ? -1 : 0;
    all[i] += samples.weights[i];
  }
  const std::vector<uint32_t>& lamps = s.lights.lamps[static_cast<size_t>(row)];
  ColoredTransmittance light(s.occluders, lamps);
  for (int i = 0; row != s.lights.dome && i < kLanes; ++i) {
    if (!valid[i] || asked.points.turned[i] == 0) continue;
    light.ignoredByLane[i] = asked.instance[i], anyTurned = true;
  }
  const bool plain = s.occluders.areSolid() && lamps.empty() && !anyTurned;
  const uint32_t blocked =
      occludedAnywhere(s.frame, valid, samples.rays, accel::RayKind::shadow, plain ? nullptr : &light,
                       {.colored = light.through}, lampOf(s, row));
  for (int i = 0; i < kLanes; ++i)
    for (int c = 0; c < 3 && !(blocked >> i & 1); ++c)
      sums[c][i] += samples.weights[i] * samples.grazing[i] * light.through[i][c];
}

/// The lanes that a light shines on.
HWY_ATTR inline uint32_t litLanes(const Shadows& s, const AskedPoints& asked, int row) {
  uint32_t lit = 0;
  for (uint32_t lanes = asked.lanes; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    lit |= (s.lights.rowsOf(asked.instance[i]).used >> row & 1) << i;
  }
  return lit;
}

HWY_ATTR void traceShadows(const Shadows& s, const AskedPoints& asked, Visibility& visibility) {
  const PixelSeeds seeds = seedsOf(s.frame, asked);
  LightSamples samples;
  for (int row = 0; row < static_cast<int>(s.lights.lights.size()); ++row) {
    for (Row& channel : visibility.lights[row]) std::fill_n(channel, kLanes, 1.0f);  // nothing to hide
    const uint32_t lit = litLanes(s, asked, row);
    if (!lit) continue;
    const int count = partOf(s.raysOf(row), asked.share);
    const uint32_t first = firstSample(s.frame, asked.sample, count);
    Row sums[3] = {}, all = {};
    for (int k = 0; k < count; ++k) {
      aimAtLight(s, row, asked.points, seeds, first + static_cast<uint32_t>(k), samples);
      addArriving(s, row, asked, lit, samples, sums, all);
    }
    for (int c = 0; c < 3; ++c)
      for (int i = 0; i < kLanes; ++i) {
        const float seen = all[i] > 0 ? sums[c][i] / all[i] : 0;
        if (lit >> i & 1) visibility.lights[row][c][i] = 1 - s.strength * (1 - seen);
      }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gluray::render {

HWY_EXPORT(traceShadows);

Shadows::Shadows(const FrameData& f, const Metric& m, const Occluders& o, const ShadowLights& l)
    : frame(f),
      metric(m),
      occluders(o),
      lights(l),
      samples(samplesOf(f, f.snapshot->settings.shadows.samples)),
      size(f.snapshot->settings.shadows.size),
      strength(f.snapshot->settings.shadows.strength) {}

bool Shadows::isSampled(int row) const {
  using Kind = scene::LightSource::Kind;
  if (row == lights.dome) return true;
  const scene::LightSource& light = lights.lights[static_cast<size_t>(row)];
  return light.kind == Kind::rectangle || light.kind == Kind::disc || light.angle > 0 || light.radius > 0 ||
         size > 0;
}

void Shadows::estimate(const AskedPoints& asked, Visibility& visibility) const noexcept {
  HWY_DYNAMIC_DISPATCH(traceShadows)(*this, asked, visibility);
}

}  // namespace gluray::render
#endif
