// Traces a packet's rays and shades their nearest accepted hits. Part of kernels.cpp (compiled once for each
// instruction set).
#if defined(GLURAY_RENDER_TRACE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_TRACE_INL_H_
#undef GLURAY_RENDER_TRACE_INL_H_
#else
#define GLURAY_RENDER_TRACE_INL_H_
#endif

#include "render/packets/hits.inl.h"
#include "render/packets/kept_hits.inl.h"
#include "render/packets/known_depths.inl.h"

#include <hwy/cache_control.h>

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

// Eye-space rays through window positions x, y, for impostors.
HWY_ATTR inline void aimInEye(const FrameData& frame, const float* x, const float* y, accel::PixelRays& to) {
  accel::RayPacket rays;
  alignas(64) int32_t valid[kLanes] = {};
  const bool inWorld = frame.rays.startAtSphere;  // then t starts at the sphere
  generateRays(inWorld ? frame.rays : frame.eyeRays, x, y, rays, valid);
  const glm::mat4 m(inWorld ? frame.snapshot->eyeFromWorld : glm::dmat4(1));
  for (int i = 0; i < kLanes; ++i) {
    const glm::vec3 org(m * glm::vec4(rays.orgX[i], rays.orgY[i], rays.orgZ[i], 1));
    const glm::vec3 dir = glm::mat3(m) * glm::vec3(rays.dirX[i], rays.dirY[i], rays.dirZ[i]);
    to.orgX[i] = org.x, to.orgY[i] = org.y, to.orgZ[i] = org.z;
    to.dirX[i] = dir.x, to.dirY[i] = dir.y, to.dirZ[i] = dir.z;
    to.tFar[i] = rays.tFar[i];
    to.windowX[i] = x[i], to.windowY[i] = y[i];
  }
}

// Generates the rays of a packet; returns the rays for impostors, null if there are none.
HWY_ATTR inline const accel::ImpostorQuery* aimRays(const FrameData& frame, Work& work) {
  if (work.lens) {
    generateLensRays(frame.rays, {work.lens->world, work.lensPoints}, work.x, work.y, work.packet,
                     work.valid);
    work.impostors = {};  // as solids
    return frame.world->hasImpostors() ? &work.impostors : nullptr;
  }
  generateRays(frame.rays, work.x, work.y, work.packet, work.valid);
  if (!frame.world->hasImpostors()) return nullptr;
  alignas(64) float x[kLanes], y[kLanes];
  for (int i = 0; i < kLanes; ++i) {
    x[i] = frame.averages ? work.x[i] : std::floor(work.x[i]) + 0.5f;
    y[i] = frame.averages ? work.y[i] : std::floor(work.y[i]) + 0.5f;
  }
  aimInEye(frame, x, y, work.centers);
  work.impostors = {&work.centers, &work.centers};
  if (frame.samplePositions.size() > 1 && !frame.averages) {
    aimInEye(frame, work.x, work.y, work.samples);
    work.impostors.samples = &work.samples;
  }
  return &work.impostors;
}

// Prefetches the indices of the triangles that `lanes` hit. Always inlined: GCC takes a function that only
// prefetches for one without effects, and drops its calls.
HWY_INLINE void prefetchTriangles(const FrameData& frame, uint32_t lanes, const uint32_t* instance,
                                  const uint32_t* primitive) {
  for (; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    const scene::Mesh& mesh = *frame.surfaces[instance[i]].mesh;
    if (mesh.indices) hwy::Prefetch(mesh.indices.data + static_cast<size_t>(primitive[i]) * 12);
  }
}

// First stage: traces the rays; prefetches the hit triangles' indices.
HWY_ATTR inline void traceWork(const FrameData& frame, Work& work) {
  const accel::ImpostorQuery* impostors = aimRays(frame, work);
  work.hits = 0;
  if (frame.snapshot->layers) {  // traced later, several hits at a time
    for (int i = 0; i < kLanes; ++i)
      if (work.valid[i]) work.hits |= 1u << i;
    return;
  }
  alignas(64) int32_t shortened[kLanes];
  const int32_t* valid = work.valid;
  if (frame.knownDepths) shortenRays(*frame.knownDepths, work, shortened), valid = shortened;
  frame.world->intersect(valid, work.packet, work.lens ? nullptr : frame.accepted.get(), impostors,
                         work.coherence());
  work.hits = lanesThatHit(work.packet, valid);
  prefetchTriangles(frame, work.hits, work.packet.instance, work.packet.primitive);
}

// Second stage: loads the indices of the triangles that `lanes` hit; prefetches their positions and normals.
HWY_ATTR inline void fetchVertices(const FrameData& frame, uint32_t lanes, const uint32_t* instance,
                                   const uint32_t* primitive, uint32_t (&to)[3][kLanes]) {
  for (; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    const scene::Mesh& mesh = *frame.surfaces[instance[i]].mesh;
    uint32_t vertex[3];
    loadTriangle(mesh, primitive[i], vertex);
    for (int k = 0; k < 3; ++k) {
      to[k][i] = vertex[k];
      hwy::Prefetch(mesh.positions.data + static_cast<size_t>(vertex[k]) * mesh.positions.stride);
      for (const scene::Attribute* a : {&mesh.normals, &mesh.texcoords, &mesh.colors})
        if (*a) hwy::Prefetch(a->data + static_cast<size_t>(vertex[k]) * a->stride);
    }
  }
}

HWY_ATTR inline void fetchVertices(const FrameData& frame, uint32_t lanes, Work& work) {
  fetchVertices(frame, lanes, work.packet.instance, work.packet.primitive, work.vertex);
}

HWY_ATTR inline void fetchVertices(const FrameData& frame, Work& work) {
  fetchVertices(frame, work.hits, work);
}

// Continues the rays of `lanes` behind their hits, with the filter. `passed`: distances that the rays have
// passed, initially 0.
HWY_ATTR inline void traceOn(const FrameData& frame, uint32_t lanes, RejectingFilter& filter, float* passed,
                             Work& work) {
  for (int i = 0; i < kLanes; ++i) work.valid[i] = lanes >> i & 1 ? -1 : 0;
  for (; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    passed[i] = filter.refuse(work.packet, i);
  }
  const accel::ImpostorQuery* impostors = aimRays(frame, work);
  for (int i = 0; i < kLanes; ++i) work.packet.tNear[i] = std::max(work.packet.tNear[i], passed[i]);
  frame.world->intersect(work.valid, work.packet, &filter, impostors, work.coherence());
  work.hits = lanesThatHit(work.packet, work.valid);
  fetchVertices(frame, work);
}

// Shades the nearest accepted hit of each lane, or keeps it, if visibility is collected first, or depths are
// exchanged (FrameData::seen).
HWY_ATTR inline void shadeNearest(const FrameData& frame, Work& work) {
  const bool wide = !frame.bytes;
  const auto take = [&](uint32_t lanes, const LitRows& rows, const float* depth) HWY_ATTR {
    if (!work.lights)
      mergeDepths(lanes, depth, work), keepHits(*frame.seen, lanes, work);
    else if (!frame.hits)
      mergeShown(lanes, rows, depth, wide, work);
    else if (frame.caughtOcclusion)
      mergeDepths(lanes, depth, work);
    else
      keepHits(*frame.hits, lanes, work);
  };
  uint32_t lanes = shadeHits(frame, work.hits, true, work, take);
  if (!lanes) return;
  work.edged &= ~lanes;
  RejectingFilter filter(frame, nullptr, work.lens ? &work.lensPoints : nullptr);
  alignas(64) float passed[kLanes] = {};
  while (lanes) {
    traceOn(frame, lanes, filter, passed, work);
    lanes = shadeHits(frame, work.hits, false, work, take);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
