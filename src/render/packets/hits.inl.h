// The colours and depths of a packet's hits. Part of kernels.cpp (compiled once for each
// instruction set).
#if defined(GLURAY_RENDER_HITS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_HITS_INL_H_
#undef GLURAY_RENDER_HITS_INL_H_
#else
#define GLURAY_RENDER_HITS_INL_H_
#endif

#include "render/hit_points/capsule.inl.h"
#include "render/hit_points/stick.inl.h"
#include "render/integrators/direct_look.h"
#include "render/integrators/integrator.h"
#include "render/integrators/light_visibility.h"
#include "render/packets/work.inl.h"

#include <algorithm>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// Whether a hit is neither culled nor clipped by the instance's own planes. Fixed function clips triangles;
/// programs discard fragments, at the pixels' centres if these are given. `lens`: where the rays leave it.
inline bool isLeft(const FrameData& frame, uint32_t instance, uint32_t primitive, float u, float v,
                   const Centers* centers, int lane, const LensPoints* lens = nullptr) {
  const Surface& surface = frame.surfaces[instance];
  if (lens) {
    const glm::dvec4 viewer = frame.lens->objects[instance].throughLens(
        surface.depth.b, double{lens->x[lane]}, double{lens->y[lane]});
    return surface.acceptsFrom(viewer, primitive, u, v);
  }
  const bool program = surface.lighting->shading->fragment.model != scene::FragmentShading::Model::off;
  if (!centers || !program || !surface.ownClipPlanes) return surface.accepts(primitive, u, v);
  const WindowMap map(frame.snapshot->camera.viewport);
  const glm::dvec2 ndc = map.ndcOf({centers->x[lane], centers->y[lane]});
  const glm::vec2 weights = surface.weightsAt(primitive, ndc);
  return surface.accepts(primitive, weights.x, weights.y);
}

/// Rejects hits that are culled, clipped by their instance's own planes, or that failed the alpha test.
class RejectingFilter : public accel::HitFilter {
 public:
  explicit RejectingFilter(const FrameData& frame, const Centers* centers = nullptr,
                           const LensPoints* lens = nullptr)
      : frame_(frame), centers_(centers), lens_(lens) {}
  bool accepts(uint32_t instance, uint32_t primitive, float u, float v, int lane) const noexcept override {
    for (const Hit& hit : failed_[lane])
      if (hit.instance == instance && hit.primitive == primitive) return false;
    return isLeft(frame_, instance, primitive, u, v, centers_, lane, lens_);
  }
  /// Makes the lane's ray ignore its hit. Returns the distance from which to continue: slightly less than the
  /// hit's, because further hits may lie at that distance, up to rounding.
  float refuse(const accel::RayPacket& packet, int lane) {
    constexpr float kBefore = 1 - 0x1p-20f;
    const float passed = packet.tFar[lane] * kBefore;
    std::erase_if(failed_[lane], [&](const Hit& hit) { return hit.distance < passed; });
    failed_[lane].push_back({packet.instance[lane], packet.primitive[lane], packet.tFar[lane]});
    return passed;
  }

 private:
  struct Hit {
    uint32_t instance, primitive;
    float distance;
  };
  const FrameData& frame_;
  const Centers* centers_;
  const LensPoints* lens_;
  std::vector<Hit> failed_[kLanes];
};

// Lanes whose hit is culled or clipped by the instance's own planes.
HWY_ATTR inline uint32_t rejectedLanes(const Surface& s, const Group& group, uint32_t ccw, bool lens) {
  uint32_t rejected = ((s.cullsCcw ? ccw : 0) | (s.cullsCw ? ~ccw : 0)) & group.lanes;
  if (!s.ownClipPlanes) return rejected;
  for (uint32_t lanes = group.lanes & ~rejected; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    const bool left = lens ? !s.isCutAway(group.primitive[i], group.u[i], group.v[i])
                           : s.accepts(group.primitive[i], group.u[i], group.v[i]);
    if (!left) rejected |= 1u << i;
  }
  return rejected;
}

/// Rays pass slightly beside their samples (ray_setup.cpp): moves the group's hit points to the samples.
/// Triangles grown by their edges are hit there already.
HWY_ATTR inline void moveToSamples(const DepthAndFacing& seen, uint32_t edged, Group& group) {
  blendRow(~edged, seen.u, group.u), blendRow(~edged, seen.v, group.v);
}

/// Computes the group's hit points, depth and facing at window positions x, y.
HWY_ATTR inline void locateHits(const FrameData& frame, uint32_t instance, const float* x, const float* y,
                                Group& group, DepthAndFacing& seen) {
  const Surface& surface = frame.surfaces[instance];
  loadCorners(*surface.mesh, group);
  if (surface.mesh->shape == scene::Shape::triangles)
    computeDepth(frame, surface, group, x, y, seen);
  else if (scene::isInWindow(surface.mesh->shape))
    computePixelImpostors(surface, frame.world->impostorsOf(instance), x, y, group, seen);
  else if (scene::isSolid(surface.mesh->shape))
    computeCapsules(surface, frame.world->impostorsOf(instance), frame.depth, x, y, group, seen);
  else if (surface.mesh->shape == scene::Shape::sticks)
    computeSticks(surface, frame.world->impostorsOf(instance), frame.depth, x, y, true, group, seen);
  else
    computeImpostors(surface, frame.depth, Pinhole(), x, y, group, seen);
}

/// The same for hits of rays through the lens. x, y become the window positions where the viewpoint sees the
/// hit points.
HWY_ATTR HWY_NOINLINE inline void locateThroughLens(const FrameData& frame, uint32_t instance,
                                                    const Work& work, Group& group, DepthAndFacing& seen,
                                                    float* x, float* y) {
  const Surface& surface = frame.surfaces[instance];
  loadCorners(*surface.mesh, group);
  const Lens& lens = *work.lens;
  if (surface.mesh->shape == scene::Shape::triangles)
    return seeTriangles(frame, surface, {lens.objects[instance], work.lensPoints}, group, seen, x, y);
  std::copy_n(work.x, kLanes, x), std::copy_n(work.y, kLanes, y);
  if (scene::isSolid(surface.mesh->shape)) {
    seePoints(frame, work.packet, group.lanes, x, y);
    return computeCapsules(surface, frame.world->impostorsOf(instance), frame.depth, x, y, group, seen);
  }
  if (surface.mesh->shape == scene::Shape::sticks) {
    seePoints(frame, work.packet, group.lanes, x, y);
    return computeSticks(surface, frame.world->impostorsOf(instance), frame.depth, x, y, false, group, seen);
  }
  if (!scene::isInWindow(surface.mesh->shape))
    return computeImpostors(surface, frame.depth, OpenLens{lens.lightings[instance], work.lensPoints}, x, y,
                            group, seen);
  seePoints(frame, work.packet, group.lanes, x, y);
  computePixelImpostors(surface, frame.world->impostorsOf(instance), x, y, group, seen);
}

/// Where hits are known before they are lit.
struct LightKnown {
  const Visibility* visibility = nullptr;
  WaitingPoints* waiting = nullptr;
  Cover cover;
  const float* depth = nullptr;  // of the hits, if there is a cover
};

/// The largest share of a pixel's colour that one of the lanes has.
HWY_ATTR inline float shareOf(uint32_t lanes, const LightKnown& known, const float* opacity) {
  float most = 0;
  for (; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    most = std::max(most, (1 - known.cover.at(i, known.depth[i])) * opacity[i]);
  }
  return std::min(most, 1.0f);
}

/// Gives a group's hits to the integrator, which changes their colours, and to the tone map. Not inlined, so
/// that frames without either keep their code. Bit i of `back`: lane i shows its back face.
HWY_ATTR HWY_NOINLINE inline void lightHits(const FrameData& frame, uint32_t instance, const Group& group,
                                            uint32_t back, int sample, const float* x, const float* y,
                                            LitRows& rows, const LightKnown& known = {}) {
  if (!group.lanes || (frame.lens && sample == 0)) return;
  if (frame.integrator) {
    ColoredHits hits{frame.surfaces[instance], instance, group, back, sample, x, y};
    hits.visibility = known.visibility, hits.waiting = known.waiting;
    if (known.cover.opacity) hits.share = shareOf(group.lanes, known, rows.value[3]);
    LitRows direct;
    const bool collects = frame.collector && !known.visibility;
    if (frame.direct && !collects) {
      shade(frame, frame.direct->surfaces[instance], group, back, x, y, direct);
      hits.direct = &direct;
    }
    (collects ? frame.collector : frame.integrator)->light(hits, rows);
  }
  const bool lit = isLit(*frame.surfaces[instance].lighting->shading);
  if (const auto& tone = lit ? frame.litTone : frame.tone) tone->apply(rows);
}

/// Whether the integrator shades hits again, and no alpha decides whether they are there.
inline bool isReplaced(const FrameData& frame, uint32_t instance, uint32_t lanes,
                       const Visibility& visibility) {
  const bool tested =
      frame.surfaces[instance].lighting->shading->alphaTest.function != scene::AlphaTest::always;
  return !tested &&
         static_cast<const VisibilityIntegrator*>(frame.integrator)->replaces(instance, lanes, visibility);
}

/// Shades the hits in `lanes` and calls take(lanes, colours, depths). Returns the lanes whose hit is
/// rejected: culled or clipped (tested only if `mayReject`), or failing the alpha test.
template <class Take>
HWY_ATTR uint32_t shadeHits(const FrameData& frame, uint32_t lanes, bool mayReject, const Work& work,
                            Take&& take) {
  uint32_t rejected = 0;
  Group group;
  DepthAndFacing seen;
  LitRows rows;
  alignas(64) Row throughX, throughY;  // window positions of hits through the lens
  while (lanes) {
    gather(work, lanes, group);
    lanes &= ~group.lanes;
    const uint32_t instance = work.packet.instance[std::countr_zero(group.lanes)];
    const Surface& surface = frame.surfaces[instance];
    const float *x = work.x, *y = work.y;
    if (work.lens)
      locateThroughLens(frame, instance, work, group, seen, throughX, throughY), x = throughX, y = throughY;
    else
      locateHits(frame, instance, x, y, group, seen);
    if (mayReject) {
      const uint32_t now = rejectedLanes(surface, group, seen.ccw, work.lens != nullptr);
      rejected |= now;
      group.lanes &= ~now;
      if (group.lanes == 0) continue;
    }
    if (surface.mesh->shape == scene::Shape::triangles) moveToSamples(seen, work.edged, group);
    const uint32_t back = (surface.frontIsCcw ? ~seen.ccw : seen.ccw) & group.lanes;
    // Hits that are kept need colours now only if these decide whether they are there.
    const bool kept =
        !work.colors && surface.lighting->shading->alphaTest.function == scene::AlphaTest::always;
    const bool replaced = work.visibility && isReplaced(frame, instance, group.lanes, *work.visibility);
    const uint32_t failing = kept || replaced ? 0 : shade(frame, surface, group, back, x, y, rows);
    rejected |= failing;
    group.lanes &= ~failing;
    if (work.lights && frame.changesColors())
      lightHits(frame, instance, group, back, work.sample, x, y, rows,
                {work.visibility, work.waiting, work.cover, seen.depth});
    if (instance == frame.catcher) {
      if (!frame.averages || (!frame.integrator && !frame.features)) continue;
      for (float& depth : seen.depth) depth = caughtAt(depth);
    }
    take(group.lanes, rows, seen.depth);
  }
  return rejected;
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
