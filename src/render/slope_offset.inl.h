// Polygon offset by a factor moves each triangle by its own slope. Of what a ray hits, the least depth with
// that offset is seen, which is not always the nearest hit: along silhouettes a steep front may be moved
// behind its back. Part of kernels.cpp (compiled once for each instruction set).
#if defined(GLURAY_RENDER_SLOPE_OFFSET_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_SLOPE_OFFSET_INL_H_
#undef GLURAY_RENDER_SLOPE_OFFSET_INL_H_
#else
#define GLURAY_RENDER_SLOPE_OFFSET_INL_H_
#endif

#include "render/nearest.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// Window depths of the hits in `lanes`: where the rays are, or at `centers` where a program writes one depth
/// for all samples of a pixel.
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

/// The distance along lane i's ray beyond which no triangle comes before window depth `least`: offsets by a
/// positive factor only move triangles away.
inline float reachOf(const FrameData& frame, const accel::RayPacket& rays, int i, float least) {
  const DepthMap& map = frame.depth;
  const float end = rays.tFar[i];
  if (map.slopeFactor < 0 || map.floatUnits != 0) return end;
  constexpr double kOneStep = 0x1p-23;
  const double away = map.scale > 0 ? kOneStep : -kOneStep;
  const double ndc = (least - map.constant - map.offset) / map.scale + away;
  const glm::dmat4 m = glm::transpose(frame.snapshot->camera.clipFromEye * frame.snapshot->eyeFromWorld);
  const glm::dvec4 line = m[2] - ndc * m[3];
  const glm::dvec4 org(rays.orgX[i], rays.orgY[i], rays.orgZ[i], 1);
  const glm::dvec4 dir(rays.dirX[i], rays.dirY[i], rays.dirZ[i], 0);
  const double t = -glm::dot(line, org) / glm::dot(line, dir);
  return t > 0 && t < end ? static_cast<float>(t) : end;
}

/// Makes the hit of each lane that of the least depth.
HWY_ATTR inline void pickLeastDepth(const FrameData& frame, const Centers& centers, Work& work) {
  constexpr float kBehind = 1 + 0x1p-21f;  // the hit is not found again
  const uint32_t hits = work.hits;
  if (!hits) return;
  alignas(64) Row depth = {}, least;
  fetchVertices(frame, hits, work);
  depthsOfHits(frame, hits, centers, work, least);
  accel::RayPacket best = work.packet;
  for (uint32_t lanes = hits; lanes;) {
    alignas(64) float passed[kLanes];
    for (int i = 0; i < kLanes; ++i) {
      work.valid[i] = lanes >> i & 1 ? -1 : 0;
      passed[i] = work.packet.tFar[i] * kBehind;
    }
    const accel::FigureQuery* figures = aimRays(frame, work);
    accel::RayPacket& rays = work.packet;
    for (; lanes; lanes &= lanes - 1) {
      const int i = std::countr_zero(lanes);
      rays.tNear[i] = std::max(rays.tNear[i], passed[i]);
      rays.tFar[i] = reachOf(frame, rays, i, least[i]);
      if (!(rays.tNear[i] < rays.tFar[i])) work.valid[i] = 0;
    }
    frame.world->intersect(work.valid, rays, frame.accepted.get(), figures);
    work.hits = lanesThatHit(rays, work.valid);
    fetchVertices(frame, work);
    depthsOfHits(frame, work.hits, centers, work, depth);
    for (lanes = work.hits; lanes; lanes &= lanes - 1) {
      const int i = std::countr_zero(lanes);
      const Nearest next{stepOf(frame, depth[i]), rays.instance[i], rays.primitive[i]};
      if (!isSeenBefore(frame, next, {stepOf(frame, least[i]), best.instance[i], best.primitive[i]}))
        continue;
      least[i] = depth[i];
      best.tFar[i] = rays.tFar[i], best.u[i] = rays.u[i], best.v[i] = rays.v[i];
      best.geometry[i] = rays.geometry[i];
      best.instance[i] = rays.instance[i], best.primitive[i] = rays.primitive[i];
    }
    lanes = work.hits;
  }
  work.packet = best;
  work.hits = hits;
  fetchVertices(frame, work);
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
