// What balls, capsules and sticks have in common at pixels: lines of sight, depths, lanes. Part of
// kernels.cpp (compiled once for each instruction set).
#if defined(GLURAY_RENDER_SOLID_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_SOLID_LANES_INL_H_
#undef GLURAY_RENDER_SOLID_LANES_INL_H_
#else
#define GLURAY_RENDER_SOLID_LANES_INL_H_
#endif

#include "render/hit_points/depth.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// A line of sight in lighting space; `dir`: unit length, away from the viewer.
struct Sight {
  glm::dvec3 org, dir;
};
/// Through window position (x, y).
HWY_ATTR inline Sight sightAt(const ImpostorSpace& space, double x, double y) {
  const glm::dvec4 start = space.start + x * space.startX + y * space.startY;
  const glm::dvec3 org = glm::dvec3(start) / start.w;
  return {org, glm::normalize(glm::dvec3(space.step) - space.step.w * org)};
}

/// What a lane sees: a point in lighting space, its normal, the group's u and fade.
struct SolidPoint {
  glm::dvec3 point;
  glm::vec3 normal;
  float u, fade;
};
/// Fills the group's lanes, and all others like the first one, with what `see` returns for a lane. All are
/// front-facing.
template <class See>
HWY_ATTR inline void computeSolidLanes(const Surface& surface, const DepthMap& map, const See& see,
                                       Group& group, DepthAndFacing& out) {
  const ImpostorSpace& space = surface.impostors;
  const int leader = std::countr_zero(group.lanes);
  const auto compute = [&](int i) HWY_ATTR {
    const SolidPoint seen = see(i);
    for (int c = 0; c < 3; ++c)
      group.point[c][i] = static_cast<float>(seen.point[c]), group.normal[c][i] = seen.normal[c];
    group.u[i] = seen.u, group.v[i] = 0, group.fade[i] = seen.fade;
    const glm::dvec4 point(seen.point, 1);
    const double ndc = glm::dot(space.clipZ, point) / glm::dot(space.clipW, point);
    out.depth[i] = static_cast<float>(std::clamp(ndc, -1.0, 1.0) * map.scale + map.offset);
  };
  compute(leader);
  for (int i = 0; i < kLanes; ++i) {
    if (i == leader) continue;
    if (group.lanes >> i & 1) {
      compute(i);
      continue;
    }
    for (int c = 0; c < 3; ++c)
      group.point[c][i] = group.point[c][leader], group.normal[c][i] = group.normal[c][leader];
    group.u[i] = group.u[leader], group.v[i] = 0, group.fade[i] = group.fade[leader];
    out.depth[i] = out.depth[leader];
  }
  out.ccw = surface.frontIsCcw ? ~0u : 0;
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
