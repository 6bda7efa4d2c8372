// Finds the hit of least depth where the nearest hit need not have it. Depths may depend on triangles'
// slopes, by polygon offset with a factor, or by a program that writes the pixel centre's depth for all
// samples: at silhouettes a steep front may end up behind its back. Or the depth buffer is so coarse that
// surfaces behind each other have equal depths. Part of kernels.cpp (compiled once for each instruction set).
#if defined(GLURAY_RENDER_LEAST_DEPTH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_LEAST_DEPTH_INL_H_
#undef GLURAY_RENDER_LEAST_DEPTH_INL_H_
#else
#define GLURAY_RENDER_LEAST_DEPTH_INL_H_
#endif

#include "render/edges/seen_before.h"
#include "render/packets/trace.inl.h"
#include "render/visibility/collected_hits.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// Window depths of the hits in `lanes`: at the rays, or at `centers` if a program writes one depth for all
/// samples of a pixel.
HWY_ATTR inline void depthsOfHits(const FrameData& frame, uint32_t lanes, const Centers& centers,
                                  const Work& work, float* depth) {
  Group group;
  DepthAndFacing seen;
  while (lanes) {
    gather(work, lanes, group);
    lanes &= ~group.lanes;
    const uint32_t instance = work.packet.instance[std::countr_zero(group.lanes)];
    const Surface& surface = frame.surfaces[instance];
    const bool atCenters =
        surface.lighting->shading->fragment.writesDepth || surface.mesh->shape != scene::Shape::triangles;
    const float *x = atCenters ? centers.x : work.x, *y = atCenters ? centers.y : work.y;
    locateHits(frame, instance, x, y, group, seen);
    blendRow(group.lanes, seen.depth, depth);
  }
}

/// How far behind a depth, in NDC, surfaces may be that the depth buffer does not tell from it.
inline double depthStepInNdc(const FrameData& frame) {
  constexpr double kOneStep = 0x1p-23;
  const double steps = frame.snapshot->depthSteps;
  return steps > 0 ? std::max(kOneStep, 1 / (steps * std::abs(frame.depth.scale))) : kOneStep;
}

/// The distance along lane i's ray beyond which no triangle can have a window depth below `least`.
inline float reachOf(const FrameData& frame, const accel::RayPacket& rays, int i, float least) {
  const DepthMap& map = frame.depth;
  const float end = rays.tFar[i];
  if (!std::isfinite(frame.leastDepthReach)) return end;
  const double step = depthStepInNdc(frame);
  const double away = frame.snapshot->camera.firstNdcDepth() < 0 ? step : -step;
  const double ndc = (least - map.constant - map.offset) / map.scale + away;
  const glm::dvec4 line = frame.clipZ - ndc * frame.clipW;
  const glm::dvec4 org(rays.orgX[i], rays.orgY[i], rays.orgZ[i], 1);
  const glm::dvec4 dir(rays.dirX[i], rays.dirY[i], rays.dirZ[i], 0);
  double t = -glm::dot(line, org) / glm::dot(line, dir);
  if (frame.leastDepthReach > 0) t += frame.leastDepthReach / glm::length(frame.snapshot->eyeFromWorld * dir);
  return t > 0 && t < end ? static_cast<float>(t) : end;
}

/// Continues the rays behind their hits, and collects all hits whose depth may be less.
HWY_ATTR inline void collectBehind(const FrameData& frame, const float* least, CollectedHits& behind,
                                   Work& work) {
  // Skips the same hit. In a coarse depth buffer order decides also between hits that are as near as that.
  const float skipped = frame.snapshot->depthSteps > 0 ? 1 - 0x1p-21f : 1 + 0x1p-21f;
  alignas(64) float passed[kLanes];
  for (int i = 0; i < kLanes; ++i) {
    work.valid[i] = work.hits >> i & 1 ? -1 : 0;
    passed[i] = work.packet.tFar[i] * skipped;
  }
  const accel::ImpostorQuery* impostors = aimRays(frame, work);
  accel::RayPacket& rays = work.packet;
  for (uint32_t lanes = work.hits; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    rays.tNear[i] = std::max(rays.tNear[i], passed[i]);
    rays.tFar[i] = reachOf(frame, rays, i, least[i]);
    if (!(rays.tNear[i] < rays.tFar[i])) work.valid[i] = 0;
  }
  behind.clear();
  const CollectingFilter filter(frame, behind);
  frame.world->intersect(work.valid, rays, &filter, impostors);
}

/// Replaces each lane's hit by the one of least depth, except in `edged` lanes. `behind` is scratch memory.
HWY_ATTR inline void pickLeastDepth(const FrameData& frame, const Centers& centers, CollectedHits& behind,
                                    Work& work) {
  const uint32_t all = work.hits, hits = all & ~work.edged;
  if (!hits) return;
  work.hits = hits;
  alignas(64) Row depth = {}, least;
  fetchVertices(frame, work);
  depthsOfHits(frame, hits, centers, work, least);
  accel::RayPacket best = work.packet;
  collectBehind(frame, least, behind, work);
  for (size_t n = 0; (work.hits = behind.copyHits(n, work.packet)) != 0; ++n) {
    fetchVertices(frame, work);
    depthsOfHits(frame, work.hits, centers, work, depth);
    for (uint32_t lanes = work.hits; lanes; lanes &= lanes - 1) {
      const int i = std::countr_zero(lanes);
      const accel::RayPacket& hit = work.packet;
      const Nearest next{depth[i], hit.instance[i], hit.primitive[i]};
      if (!isSeenBefore(*frame.snapshot, next, {least[i], best.instance[i], best.primitive[i]})) continue;
      least[i] = depth[i];
      best.u[i] = hit.u[i], best.v[i] = hit.v[i];
      best.instance[i] = hit.instance[i], best.primitive[i] = hit.primitive[i];
    }
  }
  work.packet = best;
  work.hits = all;
  fetchVertices(frame, work);
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
