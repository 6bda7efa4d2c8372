// SIMD intersection of rays with impostors, compiled once per instruction set.
#include "accel/impostors/placed_impostors.h"

#include <cmath>

#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "accel/impostors/impostor_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

// What follows is included once for each instruction set, after Highway's macros.
#include "accel/impostors/lanes.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::accel {
namespace HWY_NAMESPACE {

/// a*s - b
HWY_INLINE Float3 scaledMinus(const Float3& a, Float s, const Float3& b) {
  return {hn::MulSub(a.x, s, b.x), hn::MulSub(a.y, s, b.y), hn::MulSub(a.z, s, b.z)};
}

/// One vector of rays, relative to the impostor's centre.
struct Rays {
  Float3 toCenter;   // from the origin
  Float3 dir, unit;  // the direction; the same of length 1
  Float inverseLength, tFar, eye;
};

HWY_INLINE Rays raysAt(const Impostor& f, const ImpostorRays& r, int i) {
  Rays rays;
  rays.toCenter = {hn::Sub(splat(f.center.x), load(r.org[0] + i)),
                   hn::Sub(splat(f.center.y), load(r.org[1] + i)),
                   hn::Sub(splat(f.center.z), load(r.org[2] + i))};
  rays.dir = {load(r.dir[0] + i), load(r.dir[1] + i), load(r.dir[2] + i)};
  rays.inverseLength = load(r.inverseLength + i);
  const Float s = rays.inverseLength;
  rays.unit = {hn::Mul(rays.dir.x, s), hn::Mul(rays.dir.y, s), hn::Mul(rays.dir.z, s)};
  rays.tFar = load(r.tFar + i);
  rays.eye = load(r.eye + i);
  return rays;
}

/// A position on a plane of a billboard.
struct OnBillboard {
  Float t;
  Float3 from;  // relative to the impostor's centre
  Mask seen;    // between near and far plane
};

/// Intersects the rays with the plane at `offset` from the centre along `normal`.
HWY_INLINE OnBillboard onPlane(const Rays& r, const glm::vec3& normal, float offset) {
  const Float3 n = splat(normal);
  OnBillboard c;
  c.t = hn::Div(hn::Add(dot(n, r.toCenter), splat(offset)), dot(n, r.dir));
  c.from = scaledMinus(r.dir, c.t, r.toCenter);
  c.seen = hn::And(hn::Ge(c.t, hn::Zero(Tag())), hn::Le(c.t, r.tFar));
  return c;
}

HWY_INLINE Mask within(Float v, float limit) { return hn::Le(hn::Abs(v), splat(limit)); }

/// Whether the rays hit the triangle that faces the viewer.
HWY_INLINE Mask onTriangle(const Impostor& f, const OnBillboard& c) {
  constexpr float kHalfRoot3 = 0.8660254f;
  const Float x = dot(splat(f.right), c.from), y = dot(splat(f.up), c.from);
  const Float slanted = hn::MulAdd(hn::Abs(x), splat(kHalfRoot3), hn::Mul(y, splat(0.5f)));
  const Mask inside = hn::And(hn::Ge(y, splat(-f.cardRadius)), hn::Le(slanted, splat(f.cardRadius)));
  return hn::And(inside, c.seen);
}

/// Whether the rays hit the square of constant z.
HWY_INLINE Mask onSquare(const Impostor& f, const OnBillboard& c) {
  return hn::And(c.seen, hn::And(within(c.from.x, f.square.x), within(c.from.y, f.square.y)));
}

/// Clamps t to the depth range: at least the near plane's; behind the viewer: just before the far end.
HWY_INLINE Float bounded(const Rays& r, Float t) {
  const Float end = hn::Mul(hn::Min(r.tFar, splat(1e30f)), splat(1 - 0x1p-20f));
  return hn::IfThenElse(hn::Lt(t, r.eye), end, hn::Max(t, hn::Zero(Tag())));
}

/// A disc of constant z with the depths of the half sphere above it.
HWY_INLINE Mask meetHemisphere(const Impostor& f, const Rays& r, const Rays& sample, Float& t) {
  const OnBillboard c = onPlane(r, f.toViewer, 0);
  const Float open =
      hn::Sub(splat(f.radius * f.radius), hn::MulAdd(c.from.x, c.from.x, hn::Mul(c.from.y, c.from.y)));
  const Float above = hn::Sqrt(hn::Max(open, hn::Zero(Tag())));
  t = hn::Div(hn::Add(r.toCenter.z, above), r.dir.z);
  return hn::And(hn::Gt(open, hn::Zero(Tag())), onSquare(f, onPlane(sample, f.toViewer, 0)));
}

HWY_INLINE Mask meetSphere(const Impostor& f, const Rays& r, const Rays& sample, Float& t) {
  const Float b = dot(r.toCenter, r.unit);
  const Float3 nearest = scaledMinus(r.unit, b, r.toCenter);
  const Float d = hn::Sub(splat(f.radius * f.radius), dot(nearest, nearest));
  const Float half = hn::Sqrt(hn::Max(d, hn::Zero(Tag())));
  t = hn::Mul(f.inside ? hn::Add(b, half) : hn::Sub(b, half), r.inverseLength);
  Mask met = hn::Ge(d, hn::Zero(Tag()));
  if (f.billboards == scene::Impostors::Billboards::triangle)
    met = hn::And(met, onTriangle(f, onPlane(sample, f.toViewer, 0)));
  else
    met = hn::And(met, hn::And(hn::Ge(t, hn::Zero(Tag())), hn::Le(t, r.tFar)));
  if (f.billboards == scene::Impostors::Billboards::square)
    met = hn::And(met, onSquare(f, onPlane(sample, f.toViewer, 0)));
  return met;
}

HWY_INLINE Mask meetDisc(const Impostor& f, const Rays& r, const Rays& sample, Float& t) {
  const OnBillboard c = onPlane(r, f.toViewer, 0);
  t = c.t;
  const bool triangle = f.billboards == scene::Impostors::Billboards::triangle;
  if (f.gaussian) return onTriangle(f, onPlane(sample, f.toViewer, 0));
  const Mask met = hn::Le(dot(c.from, c.from), splat(f.radius * f.radius));
  return hn::And(met, triangle ? onTriangle(f, onPlane(sample, f.toViewer, 0)) : c.seen);
}

/// Whether the rays hit the box's side that faces the viewer, or the end that the axis points to.
HWY_INLINE Mask onFaces(const Impostor& f, const Rays& r) {
  const OnBillboard side = onPlane(r, f.up, -f.cardRadius);
  const Mask onSide = hn::And(side.seen, hn::And(within(dot(splat(f.right), side.from), f.cardRadius),
                                                 within(dot(splat(f.axis), side.from), f.halfLength)));
  const OnBillboard end = onPlane(r, f.axis, f.halfLength);
  const Mask onEnd = hn::And(end.seen, hn::And(within(dot(splat(f.right), end.from), f.cardRadius),
                                               within(dot(splat(f.up), end.from), f.cardRadius)));
  return hn::Or(onSide, onEnd);
}

HWY_INLINE Mask meetCylinder(const Impostor& f, const Rays& r, const Rays& sample, Float& t) {
  const Float zero = hn::Zero(Tag());
  const Float3 axis = splat(f.axis);
  const Float dirZ = dot(axis, r.unit), orgZ = hn::Neg(dot(axis, r.toCenter));
  // Components perpendicular to the axis: of the direction, and of the vector from the axis to the origin.
  const Float3 d =
      scaledMinus(axis, hn::Neg(dirZ), {hn::Neg(r.unit.x), hn::Neg(r.unit.y), hn::Neg(r.unit.z)});
  const Float3 o = scaledMinus(axis, hn::Neg(orgZ), r.toCenter);
  const Float a = hn::Max(dot(d, d), splat(1e-20f));
  const Float s = hn::Neg(hn::Div(dot(o, d), a));  // closest to the axis
  const Float3 nearest = {hn::MulAdd(d.x, s, o.x), hn::MulAdd(d.y, s, o.y), hn::MulAdd(d.z, s, o.z)};
  const Float discriminant = hn::Sub(splat(f.radius * f.radius), dot(nearest, nearest));
  const Float half = hn::Sqrt(hn::Div(hn::Max(discriminant, zero), a));
  const Float enter = hn::Sub(s, half), leave = hn::Add(s, half);
  const Float enterZ = hn::MulAdd(enter, dirZ, orgZ), leaveZ = hn::MulAdd(leave, dirZ, orgZ);
  const Float end = splat(f.halfLength);
  const Mask onMantle = hn::Le(hn::Abs(enterZ), end);
  const Mask onEnd = hn::And(hn::Gt(enterZ, end), hn::Le(leaveZ, end));
  const Float toEnd = hn::Div(hn::Sub(end, orgZ), dirZ);
  t = hn::Mul(hn::IfThenElse(onMantle, enter, toEnd), r.inverseLength);
  Mask met = hn::And(hn::Ge(discriminant, zero), hn::Or(onMantle, onEnd));
  if (f.billboards == scene::Impostors::Billboards::faces)
    met = hn::And(met, onFaces(f, sample));
  else
    met = hn::And(met, hn::And(hn::Ge(t, zero), hn::Le(t, r.tFar)));
  return met;
}

uint32_t meetLanes(const Impostor& f, const ImpostorRays& rays, const ImpostorRays& samples, uint32_t lanes,
                   float* t) {
  uint32_t all = 0;
  for (int i = 0; i < kLanes; i += width()) {
    if (!(lanes >> i & ((1u << width()) - 1))) continue;
    const Rays r = raysAt(f, rays, i);
    const Rays sample = &samples == &rays ? r : raysAt(f, samples, i);
    Float at;
    Mask met;
    if (f.hemisphere)
      met = meetHemisphere(f, r, sample, at);
    else if (f.shape == scene::Shape::spheres)
      met = meetSphere(f, r, sample, at);
    else if (f.shape == scene::Shape::discs)
      met = meetDisc(f, r, sample, at);
    else
      met = meetCylinder(f, r, sample, at);
    hn::Store(bounded(r, at), Tag(), t + i);
    uint8_t bits[8] = {};
    hn::StoreMaskBits(Tag(), met, bits);
    all |= (bits[0] | static_cast<uint32_t>(bits[1]) << 8) << i;
  }
  return all & lanes;
}

void raysToLighting(const glm::mat4& m, bool parallelView, const PixelRays& from, ImpostorRays& to) {
  for (int i = 0; i < kLanes; i += width()) {
    const Float3 o{load(from.orgX + i), load(from.orgY + i), load(from.orgZ + i)};
    const Float3 d{load(from.dirX + i), load(from.dirY + i), load(from.dirZ + i)};
    Float org[3], dir[3];
    for (int c = 0; c < 3; ++c) {
      const Float3 row = splat(glm::vec3(m[0][c], m[1][c], m[2][c]));
      org[c] = hn::Add(dot(row, o), splat(m[3][c])), dir[c] = dot(row, d);
      hn::Store(org[c], Tag(), to.org[c] + i), hn::Store(dir[c], Tag(), to.dir[c] + i);
    }
    const Float3 ways{dir[0], dir[1], dir[2]};
    const Float squared = hn::Max(dot(ways, ways), splat(1e-37f));
    // Very small and very large scenes: squares leave the range of floats.
    const Float most =
        hn::Max(hn::Max(hn::Abs(dir[0]), hn::Abs(dir[1])), hn::Max(hn::Abs(dir[2]), splat(1e-37f)));
    const Float3 shares{hn::Div(dir[0], most), hn::Div(dir[1], most), hn::Div(dir[2], most)};
    const Mask usual = hn::And(hn::Gt(squared, splat(1e-30f)), hn::Lt(squared, splat(1e30f)));
    const Float inverse = hn::Div(splat(1), hn::Sqrt(squared)),
                scaled = hn::Div(hn::Div(splat(1), hn::Sqrt(dot(shares, shares))), most);
    hn::Store(hn::IfThenElse(usual, inverse, scaled), Tag(), to.inverseLength + i);
    const Float eye = hn::Neg(hn::Div(dot({org[0], org[1], org[2]}, ways), squared));
    hn::Store(parallelView ? splat(-HUGE_VALF) : eye, Tag(), to.eye + i);
    hn::Store(load(from.tFar + i), Tag(), to.tFar + i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::accel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gluray::accel {

HWY_EXPORT(meetLanes);
HWY_EXPORT(raysToLighting);

uint32_t meet(const Impostor& impostor, const ImpostorRays& rays, const ImpostorRays& samples, uint32_t lanes,
              float (&t)[kLanes]) {
  return HWY_DYNAMIC_DISPATCH(meetLanes)(impostor, rays, samples, lanes, t);
}

void toLighting(const PlacedImpostors& placed, const PixelRays& rays, ImpostorRays& out) {
  HWY_DYNAMIC_DISPATCH(raysToLighting)(placed.lightingFromEye, placed.look.parallelView, rays, out);
}

}  // namespace gluray::accel
#endif
