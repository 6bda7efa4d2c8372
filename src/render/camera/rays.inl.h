// Ray generation, part of kernels.cpp (compiled once for each instruction set).
#if defined(GLURAY_RENDER_RAYS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_RAYS_INL_H_
#undef GLURAY_RENDER_RAYS_INL_H_
#else
#define GLURAY_RENDER_RAYS_INL_H_
#endif

#include "accel/rays/ray_packet.h"
#include "render/camera/lens.h"
#include "render/camera/ray_setup.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using accel::kLanes;
using DoubleTag = hn::CappedTag<double, 8>;
using HalfTag = hn::Rebind<float, DoubleTag>;  // as many floats as DoubleTag has doubles
using Double = hn::Vec<DoubleTag>;

HWY_INLINE Double loadDouble(const float* p) { return hn::PromoteTo(DoubleTag(), hn::Load(HalfTag(), p)); }
HWY_INLINE void storeFloat(Double v, float* p) { hn::Store(hn::DemoteTo(HalfTag(), v), HalfTag(), p); }

/// Origin + t * direction, t in [near, far], as many rays as a vector has lanes.
struct DoubleRays {
  Double org[3], dir[3], near, far;
};

HWY_INLINE Double dot3(const Double (&a)[3], const glm::dvec4& b) {
  const DoubleTag d;
  return hn::MulAdd(a[0], hn::Set(d, b.x), hn::MulAdd(a[1], hn::Set(d, b.y), hn::Mul(a[2], hn::Set(d, b.z))));
}

// Shortens the rays to the half-space dot(plane, p) >= 0.
HWY_INLINE void clipRays(const glm::dvec4& plane, DoubleRays& r) {
  const DoubleTag d;
  const Double zero = hn::Zero(d);
  const Double atOrigin = hn::Add(dot3(r.org, plane), hn::Set(d, plane.w));
  const Double along = dot3(r.dir, plane);
  const Double t = hn::Div(hn::Neg(atOrigin), along);
  const auto enters = hn::Gt(along, zero), leaves = hn::Lt(along, zero);
  const auto outside = hn::And(hn::Eq(along, zero), hn::Lt(atOrigin, zero));
  r.near = hn::IfThenElse(enters, hn::Max(r.near, t), r.near);
  r.far = hn::IfThenElse(leaves, hn::Min(r.far, t), r.far);
  r.far = hn::IfThenElse(outside, hn::Set(d, -1.0), r.far);
}

// Moves the origins along the rays to the sphere around the scene.
HWY_INLINE void moveToSphere(const RaySetup& setup, DoubleRays& r) {
  const DoubleTag d;
  const Double cx = hn::Sub(hn::Set(d, setup.sphereCenter.x), r.org[0]);
  const Double cy = hn::Sub(hn::Set(d, setup.sphereCenter.y), r.org[1]);
  const Double cz = hn::Sub(hn::Set(d, setup.sphereCenter.z), r.org[2]);
  const Double along = hn::MulAdd(cx, r.dir[0], hn::MulAdd(cy, r.dir[1], hn::Mul(cz, r.dir[2])));
  const Double squared =
      hn::MulAdd(r.dir[0], r.dir[0], hn::MulAdd(r.dir[1], r.dir[1], hn::Mul(r.dir[2], r.dir[2])));
  const Double entry =
      hn::Sub(hn::Div(along, squared), hn::Div(hn::Set(d, setup.sphereRadius), hn::Sqrt(squared)));
  const Double start = hn::Max(r.near, entry);
  for (int c = 0; c < 3; ++c) r.org[c] = hn::MulAdd(start, r.dir[c], r.org[c]);
  r.near = hn::Zero(d);
  r.far = hn::Sub(r.far, start);
}

/// Sets the fields of a packet that are constant over all queries.
HWY_ATTR inline void initPacket(accel::RayPacket& packet) {
  for (int i = 0; i < kLanes; ++i) {
    packet.time[i] = 0;
    packet.mask[i] = 0xFFFFFFFFu;
    packet.id[i] = static_cast<uint32_t>(i);
    packet.flags[i] = 0;
  }
}

HWY_ATTR inline void clearHits(accel::RayPacket& packet) {
  for (int i = 0; i < kLanes; ++i) packet.geometry[i] = packet.instance[i] = accel::kNoHit;
}

// Sets `valid` to 0 in lanes whose ray does not exist.
HWY_INLINE void refuseRays(const DoubleRays& r, Double w, int32_t* valid) {
  const DoubleTag d;
  auto ok = hn::And(hn::Gt(w, hn::Zero(d)), hn::Ge(r.far, r.near));
  for (int c = 0; c < 3; ++c) {
    ok = hn::And(ok, hn::Lt(hn::Abs(r.org[c]), hn::Set(d, kLargestRay)));
    ok = hn::And(ok, hn::Lt(hn::Abs(r.dir[c]), hn::Set(d, kLargestRay)));
  }
  alignas(64) double usable[8];
  hn::Store(hn::IfThenElse(ok, hn::Set(d, -1.0), hn::Zero(d)), d, usable);
  for (size_t i = 0; i < hn::Lanes(d); ++i) valid[i] &= static_cast<int32_t>(usable[i]);
}

/// Points of the lens that a packet's rays leave, in the unit disc.
struct LensPoints {
  alignas(64) float x[kLanes], y[kLanes];
};

/// Rays through the middle of the lens.
struct Pinhole {
  static constexpr bool kOpen = false;
  HWY_INLINE void bend(DoubleRays&, int) const {}
  /// Where programs compute what a window position shows of impostors.
  HWY_INLINE Double position(Double at) const { return hn::Add(hn::Floor(at), hn::Set(DoubleTag(), 0.5)); }
};

struct OpenLens {
  static constexpr bool kOpen = true;
  const LensShear& shear;
  const LensPoints& points;

  HWY_INLINE Double position(Double at) const { return at; }
  HWY_INLINE void bend(DoubleRays& r, int i) const {
    const DoubleTag d;
    const Double x = loadDouble(points.x + i), y = loadDouble(points.y + i);
    const Double atOrigin = hn::Add(dot3(r.org, shear.along), hn::Set(d, shear.along.w));
    const Double along = dot3(r.dir, shear.along);
    for (int c = 0; c < 3; ++c) {
      const Double aside = hn::MulAdd(x, hn::Set(d, shear.right[c]), hn::Mul(y, hn::Set(d, shear.up[c])));
      r.org[c] = hn::MulAdd(aside, atOrigin, r.org[c]);
      r.dir[c] = hn::MulAdd(aside, along, r.dir[c]);
    }
  }
};

// Generates rays for any projection, with clip planes.
template <class Bend>
HWY_ATTR inline void generateAnyRays(const RaySetup& setup, const Bend& lens, const float* x, const float* y,
                                     accel::RayPacket& packet, int32_t* valid) {
  const DoubleTag d;
  const auto set = [&](double v) HWY_ATTR { return hn::Set(d, v); };
  for (int i = 0; i < kLanes; i += static_cast<int>(hn::Lanes(d))) {
    const Double px = loadDouble(x + i), py = loadDouble(y + i);
    const auto start = [&](int c) HWY_ATTR {
      return hn::MulAdd(py, set(setup.startY[c]), hn::MulAdd(px, set(setup.startX[c]), set(setup.start[c])));
    };
    const Double w = start(3), inverseW = hn::Div(set(1.0), w);
    const Double stepW = set(setup.step.w), scale = hn::Mul(inverseW, set(setup.directionScale));
    DoubleRays r;
    for (int c = 0; c < 3; ++c) {
      r.org[c] = hn::Mul(start(c), inverseW);
      r.dir[c] = hn::Mul(hn::NegMulAdd(r.org[c], stepW, set(setup.step[c])), scale);
    }
    // The far end is w/(w + 2*stepW) away; at or beyond infinity the ray is endless.
    const Double endW = hn::MulAdd(set(2.0), stepW, w);
    const auto endless = hn::Le(endW, hn::Mul(w, set(1e-12)));
    r.near = hn::Zero(d);
    r.far =
        hn::IfThenElse(endless, set(HUGE_VAL), hn::Div(set(2.0 / setup.directionScale), hn::Div(endW, w)));
    lens.bend(r, i);
    for (const glm::dvec4& plane : setup.clipPlanes) clipRays(plane, r);
    if (setup.startAtSphere) moveToSphere(setup, r);
    refuseRays(r, w, valid + i);
    float* const org[3] = {packet.orgX + i, packet.orgY + i, packet.orgZ + i};
    float* const dir[3] = {packet.dirX + i, packet.dirY + i, packet.dirZ + i};
    for (int c = 0; c < 3; ++c) storeFloat(r.org[c], org[c]), storeFloat(r.dir[c], dir[c]);
    storeFloat(r.near, packet.tNear + i), storeFloat(r.far, packet.tFar + i);
  }
}

// Computes the first lane in double, and the other lanes, a few pixels away, from it in float.
HWY_ATTR inline void generateLinearRays(const LinearRays& linear, const float* x, const float* y,
                                        accel::RayPacket& packet) {
  const hn::CappedTag<float, kLanes> d;
  const double x0 = x[0], y0 = y[0];
  const glm::vec3 org(linear.org + x0 * linear.orgX + y0 * linear.orgY);
  const glm::vec3 dir(linear.dir + x0 * linear.dirX + y0 * linear.dirY);
  float* const orgs[3] = {packet.orgX, packet.orgY, packet.orgZ};
  float* const dirs[3] = {packet.dirX, packet.dirY, packet.dirZ};
  for (int i = 0; i < kLanes; i += static_cast<int>(hn::Lanes(d))) {
    const auto dx = hn::Sub(hn::Load(d, x + i), hn::Set(d, x[0])),
               dy = hn::Sub(hn::Load(d, y + i), hn::Set(d, y[0]));
    const auto at = [&](float base, float perX, float perY) HWY_ATTR {
      return hn::MulAdd(dy, hn::Set(d, perY), hn::MulAdd(dx, hn::Set(d, perX), hn::Set(d, base)));
    };
    for (int c = 0; c < 3; ++c) {
      hn::Store(at(org[c], linear.orgStepX[c], linear.orgStepY[c]), d, orgs[c] + i);
      hn::Store(at(dir[c], linear.dirStepX[c], linear.dirStepY[c]), d, dirs[c] + i);
    }
    hn::Store(hn::Zero(d), d, packet.tNear + i);
    hn::Store(hn::Set(d, linear.tFar), d, packet.tFar + i);
  }
}

/// Generates world-space rays through window positions x, y in an initialised packet, and clears its hits.
/// Sets `valid` to 0 in lanes whose ray does not exist; leaves other lanes unchanged.
HWY_ATTR inline void generateRays(const RaySetup& setup, const float* x, const float* y,
                                  accel::RayPacket& packet, int32_t* valid) {
  clearHits(packet);
  if (setup.linear.usable && setup.clipPlanes.empty()) return generateLinearRays(setup.linear, x, y, packet);
  generateAnyRays(setup, Pinhole(), x, y, packet, valid);
}

/// The same rays, but from points of a lens. `lens`: the shear in world space.
HWY_ATTR HWY_NOINLINE inline void generateLensRays(const RaySetup& setup, const OpenLens& lens,
                                                   const float* x, const float* y, accel::RayPacket& packet,
                                                   int32_t* valid) {
  clearHits(packet);
  generateAnyRays(setup, lens, x, y, packet, valid);
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
