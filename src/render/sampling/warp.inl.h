// From the unit square to directions. Compiled once for each instruction set.
#if defined(GLURAY_RENDER_WARP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_WARP_INL_H_
#undef GLURAY_RENDER_WARP_INL_H_
#else
#define GLURAY_RENDER_WARP_INL_H_
#endif

#include "render/sampling/sobol.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// A point of the unit disc, evenly distributed.
HWY_INLINE Sample2 unitDisc(const Sample2& u) {
  const FloatTag d;
  const Float radius = hn::Sqrt(u.x), angle = hn::Mul(u.y, splat(6.2831853f));
  return {hn::Mul(radius, hn::Cos(d, angle)), hn::Mul(radius, hn::Sin(d, angle))};
}

/// A direction about +z with density cos(theta)/pi.
HWY_INLINE Float3 cosineHemisphere(const Sample2& u) {
  const FloatTag d;
  const Float radius = hn::Sqrt(u.x), angle = hn::Mul(u.y, splat(6.2831853f));
  const Float z = hn::Sqrt(hn::Max(hn::Sub(splat(1), u.x), hn::Zero(d)));
  return {hn::Mul(radius, hn::Cos(d, angle)), hn::Mul(radius, hn::Sin(d, angle)), z};
}

/// Turns a direction about +z to one about the unit vector n (T. Duff and others, "Building an Orthonormal
/// Basis, Revisited", 2017).
HWY_INLINE Float3 aboveSurface(const Float3& n, const Float3& v) {
  const Float sign = hn::CopySign(splat(1), n.z);
  const Float a = hn::Div(splat(-1), hn::Add(sign, n.z)), b = hn::Mul(hn::Mul(n.x, n.y), a);
  const Float3 tangent{hn::MulAdd(hn::Mul(sign, hn::Mul(n.x, n.x)), a, splat(1)), hn::Mul(sign, b),
                       hn::Neg(hn::Mul(sign, n.x))};
  const Float3 bitangent{b, hn::MulAdd(hn::Mul(n.y, n.y), a, sign), hn::Neg(n.y)};
  return add(scaled(tangent, v.x), add(scaled(bitangent, v.y), scaled(n, v.z)));
}

/// `v`, mirrored to the upper side of a plane where it points below it.
HWY_INLINE Float3 reflectedAbove(const Float3& normal, const Float3& v) {
  const Float below = hn::Min(dot(normal, v), hn::Zero(FloatTag()));
  return sub(v, scaled(normal, hn::Mul(splat(2), below)));
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
