// Points, normals and depths of balls and capsules at pixels (scene/mesh.h). Part of kernels.cpp (compiled
// once for each instruction set).
#if defined(GLURAY_RENDER_CAPSULE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_CAPSULE_INL_H_
#undef GLURAY_RENDER_CAPSULE_INL_H_
#else
#define GLURAY_RENDER_CAPSULE_INL_H_
#endif

#include "accel/impostors/capsule.h"
#include "render/hit_points/solid_lanes.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// Of the group's balls and capsules at window positions x, y. Attributes of a line's ends are interpolated
/// by u. All are front-facing.
HWY_ATTR inline void computeCapsules(const Surface& surface, const accel::PlacedImpostors& placed,
                                     const DepthMap& map, const float* x, const float* y, Group& group,
                                     DepthAndFacing& out) {
  const bool unlit = surface.instance->impostors.unlit;  // by a shader program: fixed function gets a light
  const auto seeLane = [&](int i) HWY_ATTR {
    accel::Capsule capsule;
    accel::Capsule::make(placed, group.primitive[i], capsule);
    const Sight sight = sightAt(surface.impostors, x[i], y[i]);
    const accel::CapsulePoint seen = see(capsule, sight.org, sight.dir);
    return SolidPoint{seen.point, seen.normal, seen.share, unlit ? std::max(seen.cosine, 0.0f) : 1.0f};
  };
  computeSolidLanes(surface, map, seeLane, group, out);
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
