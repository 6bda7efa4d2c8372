// Points, normals and depths of sticks at pixels (scene/mesh.h). Part of kernels.cpp (compiled once for each
// instruction set).
#if defined(GLURAY_RENDER_STICK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_STICK_INL_H_
#undef GLURAY_RENDER_STICK_INL_H_
#else
#define GLURAY_RENDER_STICK_INL_H_
#endif

#include "accel/impostors/stick.h"
#include "render/visibility/depth.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// The weight of the second end's colour, as scene::Impostors says.
HWY_ATTR inline float shareOfSecond(const scene::Impostors& look, const accel::Stick& stick,
                                    const accel::StickPoint& seen) {
  if (!stick.halves) return static_cast<float>(seen.share);
  const double around = std::clamp(-double{look.halvesBlend} * seen.enterZ, 0.0, 0.5);
  if (around == 0) return seen.share < 0.5 ? 0.0f : 1.0f;
  const double t = std::clamp((seen.share - 0.5 + around) / (2 * around), 0.0, 1.0);
  return static_cast<float>(t * t * (3 - 2 * t));
}

/// Of the group's sticks at window positions x, y; `atCenters`: at the centres of their pixels, where
/// programs compute them. Colours of the ends are mixed by u. All are front-facing.
HWY_ATTR inline void computeSticks(const Surface& surface, const accel::PlacedImpostors& placed,
                                   const DepthMap& map, const float* x, const float* y, bool atCenters,
                                   Group& group, DepthAndFacing& out) {
  const ImpostorSpace& space = surface.impostors;
  const int leader = std::countr_zero(group.lanes);
  const auto position = [&](float at)
                            HWY_ATTR { return atCenters ? std::floor(double{at}) + 0.5 : double{at}; };
  const auto compute = [&](int i) HWY_ATTR {
    accel::Stick stick;
    accel::Stick::make(placed, group.primitive[i], stick);
    const glm::dvec4 start = space.start + position(x[i]) * space.startX + position(y[i]) * space.startY;
    const glm::dvec3 org = glm::dvec3(start) / start.w;
    const accel::StickPoint seen =
        see(stick, org, glm::normalize(glm::dvec3(space.step) - space.step.w * org));
    for (int c = 0; c < 3; ++c)
      group.point[c][i] = static_cast<float>(seen.point[c]), group.normal[c][i] = seen.normal[c];
    group.u[i] = shareOfSecond(surface.instance->impostors, stick, seen);
    const glm::dvec4 point(seen.point, 1);
    const double ndc = glm::dot(space.clipZ, point) / glm::dot(space.clipW, point);
    out.depth[i] = static_cast<float>(std::clamp(ndc, -1.0, 1.0) * map.scale + map.offset);
  };
  for (int i = 0; i < kLanes; ++i) group.v[i] = 0, group.fade[i] = 1;
  compute(leader);
  for (int i = 0; i < kLanes; ++i) {
    if (i == leader) continue;
    if (group.lanes >> i & 1) {
      compute(i);
      continue;
    }
    for (int c = 0; c < 3; ++c)
      group.point[c][i] = group.point[c][leader], group.normal[c][i] = group.normal[c][leader];
    group.u[i] = group.u[leader], out.depth[i] = out.depth[leader];
  }
  out.ccw = surface.frontIsCcw ? ~0u : 0;
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
