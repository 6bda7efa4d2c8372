// Visibility of triangles that grow by their painted edges (grown_triangles.h). Part of
// kernels.cpp (compiled once for each instruction set).
#if defined(GLURAY_RENDER_EDGES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_EDGES_INL_H_
#undef GLURAY_RENDER_EDGES_INL_H_
#else
#define GLURAY_RENDER_EDGES_INL_H_
#endif

#include "render/edges/edged_triangle.h"
#include "render/edges/grown_triangles.h"
#include "render/packets/trace.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// Replaces lane i's hit by a triangle if that has grown over the sample and is nearer.
HWY_ATTR inline void tryEdged(const FrameData& frame, uint32_t instance, uint32_t primitive, int i,
                              Nearest& best, Work& work) {
  const Surface& surface = frame.surfaces[instance];
  const EdgedTriangle triangle(surface, frame.snapshot->camera, primitive);
  const glm::dvec2 at(work.x[i], work.y[i]);
  if (!triangle.covers(at)) return;
  const glm::vec2 weights = triangle.weights(at);
  if (frame.accepted && !surface.accepts(primitive, weights.x, weights.y)) return;
  const double depth = frame.depth.windowDepth(triangle.ndcDepth(at));
  const Nearest next{depth, instance, primitive};
  if (!isSeenBefore(*frame.snapshot, next, best)) return;
  best = next;
  work.packet.geometry[i] = 0;
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

/// Replaces hits by triangles that have grown over the samples.
HWY_ATTR inline void pickEdged(const FrameData& frame, const GrownSamples& grown, Work& work) {
  Nearest best[kLanes];
  const accel::RayPacket centre = work.packet;
  for (uint32_t lanes = work.hits; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    const Surface& surface = frame.surfaces[centre.instance[i]];
    if (growsByEdges(surface)) {
      tryEdged(frame, centre.instance[i], centre.primitive[i], i, best[i], work);
      continue;
    }
    const double depth = frame.depth.windowDepth(ndcDepthOfHit(frame, centre, i, {work.x[i], work.y[i]}));
    best[i] = {depth, centre.instance[i], centre.primitive[i]};
  }
  for (int i = 0; i < kLanes; ++i) {
    if (!work.valid[i]) continue;
    const Nearest& next = grown.at(work.sample, work.imageX + laneX(i), work.imageY + laneY(i));
    if (next.instance != accel::kNoHit) tryEdged(frame, next.instance, next.primitive, i, best[i], work);
  }
  if (work.edged) fetchVertices(frame, work);
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
