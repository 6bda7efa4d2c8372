// Points, normals and depths of sticks at pixels (scene/mesh.h). Part of kernels.cpp (compiled once for each
// instruction set).
#if defined(GLURAY_RENDER_STICK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_STICK_INL_H_
#undef GLURAY_RENDER_STICK_INL_H_
#else
#define GLURAY_RENDER_STICK_INL_H_
#endif

#include "accel/impostors/stick.h"
#include "render/hit_points/solid_lanes.inl.h"

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
  const auto position = [&](float at)
                            HWY_ATTR { return atCenters ? std::floor(double{at}) + 0.5 : double{at}; };
  const auto seeLane = [&](int i) HWY_ATTR {
    accel::Stick stick;
    accel::Stick::make(placed, group.primitive[i], stick);
    const Sight sight = sightAt(surface.impostors, position(x[i]), position(y[i]));
    const accel::StickPoint seen = see(stick, sight.org, sight.dir);
    const float share = shareOfSecond(surface.instance->impostors, stick, seen);
    return SolidPoint{seen.point, seen.normal, share, 1};
  };
  computeSolidLanes(surface, map, seeLane, group, out);
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
