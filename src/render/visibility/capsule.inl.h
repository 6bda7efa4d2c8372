// Points, normals and depths of balls and capsules at pixels (scene/mesh.h). Part of kernels.cpp (compiled
// once for each instruction set).
#if defined(GLURAY_RENDER_CAPSULE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_CAPSULE_INL_H_
#undef GLURAY_RENDER_CAPSULE_INL_H_
#else
#define GLURAY_RENDER_CAPSULE_INL_H_
#endif

#include "accel/impostors/capsule.h"
#include "render/visibility/depth.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// The point of a capsule that the line of sight through window position (x, y) enters, lighting space.
HWY_ATTR inline accel::CapsulePoint seeCapsule(const ImpostorSpace& space, const accel::Capsule& capsule,
                                               double x, double y) {
  const glm::dvec4 start = space.start + x * space.startX + y * space.startY;
  const glm::dvec3 org = glm::dvec3(start) / start.w;
  return see(capsule, org, glm::normalize(glm::dvec3(space.step) - space.step.w * org));
}

/// Of the group's balls and capsules at window positions x, y. Attributes of a line's ends are interpolated
/// by u. All are front-facing.
HWY_ATTR inline void computeCapsules(const Surface& surface, const accel::PlacedImpostors& placed,
                                     const DepthMap& map, const float* x, const float* y, Group& group,
                                     DepthAndFacing& out) {
  const int leader = std::countr_zero(group.lanes);
  const bool unlit = surface.instance->impostors.unlit;  // by a shader program: fixed function gets a light
  const auto compute = [&](int i) HWY_ATTR {
    accel::Capsule capsule;
    accel::Capsule::make(placed, group.primitive[i], capsule);
    const accel::CapsulePoint seen = seeCapsule(surface.impostors, capsule, x[i], y[i]);
    for (int c = 0; c < 3; ++c)
      group.point[c][i] = static_cast<float>(seen.point[c]), group.normal[c][i] = seen.normal[c];
    group.u[i] = seen.share;
    group.fade[i] = unlit ? std::max(seen.cosine, 0.0f) : 1.0f;
    const glm::dvec4 point(seen.point, 1);
    const double ndc = glm::dot(surface.impostors.clipZ, point) / glm::dot(surface.impostors.clipW, point);
    out.depth[i] = static_cast<float>(std::clamp(ndc, -1.0, 1.0) * map.scale + map.offset);
  };
  for (int i = 0; i < kLanes; ++i) group.v[i] = 0;
  compute(leader);
  for (int i = 0; i < kLanes; ++i) {
    if (i == leader) continue;
    if (group.lanes >> i & 1) {
      compute(i);
      continue;
    }
    for (int c = 0; c < 3; ++c)
      group.point[c][i] = group.point[c][leader], group.normal[c][i] = group.normal[c][leader];
    group.u[i] = group.u[leader], group.fade[i] = group.fade[leader], out.depth[i] = out.depth[leader];
  }
  out.ccw = surface.frontIsCcw ? ~0u : 0;
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
