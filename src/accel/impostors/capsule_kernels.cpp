// SIMD intersection of rays with capsules, compiled once per instruction set.
#include "accel/impostors/capsule.h"

#include <bit>
#include <cmath>

#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "accel/impostors/capsule_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// What follows is included once for each instruction set, after Highway's macros.
#include "accel/impostors/lanes.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::accel {
namespace HWY_NAMESPACE {

/// What of each ray lies within a capsule: nothing where leave < enter.
struct Within {
  Float enter, leave;
  HWY_INLINE void add(Mask valid, Float from, Float to) {
    enter = hn::IfThenElse(valid, hn::Min(enter, from), enter);
    leave = hn::IfThenElse(valid, hn::Max(leave, to), leave);
  }
};

/// Rays relative to the middle of a capsule, from the points nearest to that.
struct Rays {
  Float3 from, dir;  // dir: unit length
};

HWY_INLINE void meetBall(const Rays& r, const glm::vec3& center, float radius, Within& in) {
  const Float3 from = along(r.from, splat(-1), splat(center));
  const Float t = hn::Neg(dot(from, r.dir));
  const Float3 nearest = along(from, t, r.dir);
  const Float d = hn::Sub(splat(radius * radius), dot(nearest, nearest));
  const Float half = hn::Sqrt(hn::Max(d, hn::Zero(Tag())));
  in.add(hn::Ge(d, hn::Zero(Tag())), hn::Sub(t, half), hn::Add(t, half));
}

/// The part of the cone between the circles where it touches the balls. In coordinates along and across the
/// axis, |aside + t*across| = radius + slope*place; t counts from the point nearest to the axis.
HWY_INLINE void meetCone(const Rays& r, const Capsule& c, Within& in) {
  const float cosine = std::sqrt(1 - c.sine * c.sine), slope = -c.sine / cosine;
  const Float3 axis = splat(c.axis);
  const Float start = dot(axis, r.from), dirZ = dot(axis, r.dir);
  const Float3 aside = along(r.from, hn::Neg(start), axis), across = along(r.dir, hn::Neg(dirZ), axis);
  const Float a = hn::Max(dot(across, across), splat(1e-20f));
  const Float s = hn::Neg(hn::Div(dot(aside, across), a));
  const Float3 nearest = along(aside, s, across);
  const Float n2 = dot(nearest, nearest), q = hn::Mul(splat(slope), dirZ);
  const Float place = hn::MulAdd(s, dirZ, start);
  const Float radius = hn::MulAdd(splat(slope), place, splat(0.5f * (c.radius[0] + c.radius[1]) / cosine));
  const Float discriminant = hn::MulAdd(a, hn::MulSub(radius, radius, n2), hn::Mul(hn::Mul(q, q), n2));
  const Float root = hn::Sqrt(hn::Max(discriminant, hn::Zero(Tag())));
  const Float scale = hn::Div(splat(1), hn::NegMulAdd(q, q, a)), middle = hn::Mul(radius, q);
  const Float lowest = splat(-c.halfLength + c.radius[0] * c.sine),
              highest = splat(c.halfLength + c.radius[1] * c.sine);
  const Mask real = hn::Ge(discriminant, hn::Zero(Tag()));
  const auto add = [&](Float sum) HWY_ATTR {
    const Float t = hn::Mul(sum, scale), at = hn::MulAdd(t, dirZ, place);
    const Mask valid = hn::And(real, hn::And(hn::Ge(at, lowest), hn::Le(at, highest)));
    in.add(valid, hn::Add(s, t), hn::Add(s, t));
  };
  add(hn::Sub(middle, root)), add(hn::Add(middle, root));
}

CapsuleHits meetLanes(const Capsule& whole, const ImpostorRays& rays, uint32_t lanes, float* out) {
  // In units of the capsule's size: squares of lengths then neither overflow nor vanish.
  const glm::vec3 middle = 0.5f * (whole.end[0] + whole.end[1]);
  const float size = whole.halfLength + std::max(whole.radius[0], whole.radius[1]), perSize = 1 / size;
  Capsule c = whole;
  for (float* length : {&c.radius[0], &c.radius[1], &c.halfLength}) *length *= perSize;
  const glm::vec3 half = c.halfLength * c.axis;
  const Float zero = hn::Zero(Tag()), toUnits = splat(perSize);
  CapsuleHits met;
  for (int i = 0; i < kLanes; i += width()) {
    if (!(lanes >> i & ((1u << width()) - 1))) continue;
    const Float inverse = load(rays.inverseLength + i);
    Rays r;
    r.dir = {hn::Mul(load(rays.dir[0] + i), inverse), hn::Mul(load(rays.dir[1] + i), inverse),
             hn::Mul(load(rays.dir[2] + i), inverse)};
    const auto from = [&](int axis) HWY_ATTR {
      return hn::Mul(hn::Sub(load(rays.org[axis] + i), splat(middle[axis])), toUnits);
    };
    r.from = {from(0), from(1), from(2)};
    const Float to = hn::Neg(dot(r.from, r.dir));
    r.from = along(r.from, to, r.dir);
    const Mask near = hn::Le(dot(r.from, r.from), splat(1.0001f));
    if (hn::AllFalse(Tag(), near)) continue;
    Within in{splat(HUGE_VALF), splat(-HUGE_VALF)};
    meetBall(r, -half, c.radius[0], in);
    if (!c.isBall()) meetBall(r, half, c.radius[1], in), meetCone(r, c, in);
    const Float enter = hn::Add(to, in.enter), leave = hn::Add(to, in.leave);
    const auto bitsOf = [&](Mask m) HWY_ATTR {
      uint8_t bits[8] = {};
      hn::StoreMaskBits(Tag(), m, bits);
      return (bits[0] | static_cast<uint32_t>(bits[1]) << 8) << i;
    };
    const Mask hit = hn::Ge(leave, zero);
    met.lanes |= bitsOf(hit);
    met.early |= bitsOf(hn::And(hit, hn::Lt(enter, zero)));
    hn::Store(hn::Mul(hn::Mul(hn::Max(enter, zero), splat(size)), inverse), Tag(), out + i);
  }
  met.lanes &= lanes, met.early &= lanes;
  return met;
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::accel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gluray::accel {

HWY_EXPORT(meetLanes);

uint32_t meet(const PlacedImpostors& placed, const Capsule& capsule, const ImpostorRays& rays, uint32_t lanes,
              float (&t)[kLanes]) {
  const auto met = HWY_DYNAMIC_DISPATCH(meetLanes)(capsule, rays, lanes, t);
  if (!met.early || placed.viewer.w == 0) return met.lanes;
  return capsule.holds(glm::vec3(placed.viewer) / placed.viewer.w) ? 0 : met.lanes;
}

}  // namespace gluray::accel
#endif
