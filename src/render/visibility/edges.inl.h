// Visibility of triangles that grow by their painted edges (render/local/edged_triangle.h). Part of
// kernels.cpp (compiled once for each instruction set).
#if defined(GLURAY_RENDER_EDGES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_EDGES_INL_H_
#undef GLURAY_RENDER_EDGES_INL_H_
#else
#define GLURAY_RENDER_EDGES_INL_H_
#endif

#include "render/local/edged_triangle.h"
#include "render/visibility/nearest.inl.h"

#include <span>

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// Window depth without the triangle's own part of the polygon offset.
HWY_ATTR inline double depthOf(const FrameData& frame, double ndc) {
  return ndc * frame.depth.scale + frame.depth.offset + frame.depth.constant;
}

inline bool growsByEdges(const Surface& surface) {
  const scene::FragmentShading& f = surface.lighting->shading->fragment;
  return f.edges && f.edgesGrow;
}

/// Replaces lane i's hit by the triangle that a nearby ray has hit, if that grows over the pixel and is
/// nearer.
HWY_ATTR inline void tryEdged(const FrameData& frame, const accel::RayPacket& probe, int i, Nearest& best,
                              Work& work) {
  const uint32_t instance = probe.instance[i], primitive = probe.primitive[i];
  const Surface& surface = frame.surfaces[instance];
  if (!growsByEdges(surface)) return;
  if (instance == best.instance && primitive == best.primitive) return;
  const EdgedTriangle triangle(surface, frame.snapshot->camera, primitive);
  const glm::dvec2 at(work.x[i], work.y[i]);
  if (!triangle.covers(at)) return;
  const glm::vec2 weights = triangle.weights(at);
  if (frame.accepted && !surface.accepts(primitive, weights.x, weights.y)) return;
  const double depth = depthOf(frame, triangle.ndcDepth(at));
  const Nearest next{depth, instance, primitive};
  if (!isSeenBefore(frame, next, best)) return;
  best = next;
  work.packet.geometry[i] = probe.geometry[i];
  work.packet.instance[i] = instance, work.packet.primitive[i] = primitive;
  work.packet.u[i] = weights.x, work.packet.v[i] = weights.y;
  work.edgeDepth[i] = static_cast<float>(std::clamp(depth, 0.0, 1.0));
  work.edged |= 1u << i;
  work.hits |= 1u << i;
}

/// NDC depth of lane i's hit at the sample's window position, which the ray misses slightly (ray_setup.cpp).
HWY_ATTR inline double ndcDepthOfHit(const FrameData& frame, const accel::RayPacket& packet, int i,
                                     const glm::dvec2& sample) {
  const Surface& surface = frame.surfaces[packet.instance[i]];
  if (surface.mesh->shape == scene::Shape::triangles) {
    const WindowMap map(frame.snapshot->camera.viewport);
    const glm::vec2 weights = surface.weightsAt(packet.primitive[i], map.ndcOf(sample));
    return surface.ndcDepth(packet.primitive[i], weights.x, weights.y);
  }
  const double t = packet.tFar[i];
  const glm::dvec4 world(packet.orgX[i] + t * packet.dirX[i], packet.orgY[i] + t * packet.dirY[i],
                         packet.orgZ[i] + t * packet.dirZ[i], 1);
  const glm::dvec4 clip = frame.snapshot->camera.clipFromEye * (frame.snapshot->eyeFromWorld * world);
  return clip.z / clip.w;
}

HWY_ATTR inline void tryProbe(const FrameData& frame, const Work& probe, Nearest* best, Work& work) {
  for (uint32_t lanes = probe.hits; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    tryEdged(frame, probe.packet, i, best[i], work);
  }
}

/// Lanes on an outline: either the probe or the pixel's centre misses, or one hit is much farther away.
HWY_ATTR inline uint32_t lanesAtOutline(const accel::RayPacket& centre, uint32_t hits, const Work& probe) {
  constexpr float kMuch = 0.02f;
  uint32_t outline = hits ^ probe.hits;
  for (uint32_t lanes = hits & probe.hits; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    const float a = centre.tFar[i], b = probe.packet.tFar[i];
    if (std::abs(a - b) > kMuch * std::min(a, b)) outline |= 1u << i;
  }
  return outline;
}

/// Traces probes beside the pixels' centres, to find triangles that grow over the centres.
HWY_ATTR inline void pickEdged(const FrameData& frame, const int32_t* valid, Work& work) {
  Nearest best[kLanes];
  const accel::RayPacket centre = work.packet;
  const uint32_t hits = work.hits;
  for (uint32_t lanes = hits; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    const Surface& surface = frame.surfaces[centre.instance[i]];
    if (growsByEdges(surface)) {
      tryEdged(frame, centre, i, best[i], work);
      continue;
    }
    const double depth = depthOf(frame, ndcDepthOfHit(frame, centre, i, {work.x[i], work.y[i]}));
    best[i] = {depth, centre.instance[i], centre.primitive[i]};
  }
  // Probe directions, in units of a quarter of the line width.
  static constexpr glm::vec2 kWays[] = {{1, 1},    {-1, 1},    {1, -1},   {-1, -1},
                                        {1.4f, 0}, {-1.4f, 0}, {0, 1.4f}, {0, -1.4f}};
  constexpr float kWide = 1.5f;  // pixels
  const bool wide = frame.widestEdge > kWide;
  const float reach = 0.255f * frame.widestEdge;
  Work probes[std::size(kWays)];
  const std::span<Work> used(probes, wide ? std::size(kWays) : 4);
  uint32_t outline = wide ? ~0u : 0u;
  for (size_t p = 0; p < used.size(); ++p) {
    Work& probe = used[p];
    initPacket(probe.packet);
    for (int i = 0; i < kLanes; ++i) {
      probe.x[i] = work.x[i] + reach * kWays[p].x, probe.y[i] = work.y[i] + reach * kWays[p].y;
      probe.valid[i] = valid[i];
    }
    traceWork(frame, probe);
    tryProbe(frame, probe, best, work);
    outline |= lanesAtOutline(centre, hits, probe);
  }
  // A triangle that grows beyond an outline may lie behind the visible surface.
  for (Work& probe : used) {
    const uint32_t lanes = probe.hits & outline;
    if (!lanes) continue;
    traceBehind(frame, lanes, probe);
    tryProbe(frame, probe, best, work);
  }
  if (work.edged) fetchVertices(frame, work);
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
