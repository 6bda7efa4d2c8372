// SIMD intersection of rays with sticks, compiled once per instruction set.
#include "accel/impostors/stick.h"

#include <cmath>

#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "accel/impostors/stick_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// What follows is included once for each instruction set, after Highway's macros.
#include "accel/impostors/lanes.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::accel {
namespace HWY_NAMESPACE {

/// Rays in coordinates along and across a stick's axis, relative to its middle; t counts from the point
/// nearest to that.
struct StickRays {
  Float3 from, dir, aside, across;
  Float start, along;
};

struct StickMet {
  Float t;
  Mask met;
};

/// Where rays that are within the endless cylinder beyond end k pass that end. `side`: -1 or 1.
HWY_INLINE StickMet throughEnd(const StickRays& r, const Stick& s, float half, float radius, int k) {
  const float side = k == 0 ? -1.0f : 1.0f, squared = radius * radius;
  const Float zero = hn::Zero(Tag());
  if (s.ends[k] == Stick::End::open) return {zero, hn::Gt(zero, zero)};
  if (s.ends[k] == Stick::End::round) {
    const Float3 to = along(r.from, splat(-side * half), splat(s.axis));
    const Float middle = hn::Neg(dot(to, r.dir));
    const Float3 closest = along(to, middle, r.dir);
    const Float d = hn::Sub(splat(squared), dot(closest, closest));
    return {hn::Sub(middle, hn::Sqrt(hn::Max(d, zero))), hn::Ge(d, zero)};
  }
  const Float t = hn::Div(hn::Sub(splat(side * half), r.start), r.along);
  const Float3 out = along(r.aside, t, r.across);
  const Mask inwards = hn::Lt(hn::Mul(r.along, splat(side)), zero);
  return {t, hn::And(inwards, hn::Le(dot(out, out), splat(squared)))};
}

HWY_INLINE StickMet meetCylinder(const StickRays& r, const Stick& s, float half, float radius) {
  const Float zero = hn::Zero(Tag());
  const Float a = hn::Max(dot(r.across, r.across), splat(1e-20f));
  const Float middle = hn::Neg(hn::Div(dot(r.aside, r.across), a));
  const Float3 closest = along(r.aside, middle, r.across);
  const Float d = hn::Sub(splat(radius * radius), dot(closest, closest));
  const Float enter = hn::Sub(middle, hn::Sqrt(hn::Div(hn::Max(d, zero), a)));
  const Float place = hn::MulAdd(enter, r.along, r.start);
  const Mask low = hn::Lt(place, splat(-half)), high = hn::Gt(place, splat(half));
  const StickMet first = throughEnd(r, s, half, radius, 0), second = throughEnd(r, s, half, radius, 1);
  StickMet m{enter, hn::Ge(d, zero)};
  m.t = hn::IfThenElse(low, first.t, hn::IfThenElse(high, second.t, enter));
  m.met = hn::And(m.met, hn::Or(hn::AndNot(low, hn::Or(hn::Not(high), second.met)), hn::And(low, first.met)));
  return m;
}

uint32_t meetStickLanes(const Stick& s, const ImpostorRays& rays, uint32_t lanes, float* out) {
  // In units of the stick's size: squares of lengths then neither overflow nor vanish.
  const glm::vec3 center = s.middle();
  const float size = s.halfLength + s.radius, perSize = 1 / size;
  const float half = s.halfLength * perSize, radius = s.radius * perSize;
  const Float zero = hn::Zero(Tag()), toUnits = splat(perSize);
  const Float3 axis = splat(s.axis);
  uint32_t all = 0;
  for (int i = 0; i < kLanes; i += width()) {
    if (!(lanes >> i & ((1u << width()) - 1))) continue;
    const Float inverse = load(rays.inverseLength + i);
    StickRays r;
    r.dir = {hn::Mul(load(rays.dir[0] + i), inverse), hn::Mul(load(rays.dir[1] + i), inverse),
             hn::Mul(load(rays.dir[2] + i), inverse)};
    const auto from = [&](int c) HWY_ATTR {
      return hn::Mul(hn::Sub(load(rays.org[c] + i), splat(center[c])), toUnits);
    };
    r.from = {from(0), from(1), from(2)};
    const Float to = hn::Neg(dot(r.from, r.dir));
    r.from = along(r.from, to, r.dir);
    if (hn::AllFalse(Tag(), hn::Le(dot(r.from, r.from), splat(1.0001f)))) continue;
    r.start = dot(axis, r.from), r.along = dot(axis, r.dir);
    r.aside = along(r.from, hn::Neg(r.start), axis), r.across = along(r.dir, hn::Neg(r.along), axis);
    const StickMet m = meetCylinder(r, s, half, radius);
    const Float t = hn::Mul(hn::Mul(hn::Add(to, m.t), splat(size)), inverse);
    const Mask seen = hn::And(m.met, hn::And(hn::Ge(t, zero), hn::Le(t, load(rays.tFar + i))));
    hn::Store(t, Tag(), out + i);
    uint8_t bits[8] = {};
    hn::StoreMaskBits(Tag(), seen, bits);
    all |= (bits[0] | static_cast<uint32_t>(bits[1]) << 8) << i;
  }
  return all & lanes;
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::accel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gluray::accel {

HWY_EXPORT(meetStickLanes);

uint32_t meet(const Stick& stick, const ImpostorRays& rays, uint32_t lanes, float (&t)[kLanes]) {
  return HWY_DYNAMIC_DISPATCH(meetStickLanes)(stick, rays, lanes, t);
}

}  // namespace gluray::accel
#endif
