// From the unit square to directions towards lights. Compiled once for each instruction set.
#if defined(GLURAY_RENDER_LIGHTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_LIGHTS_INL_H_
#undef GLURAY_RENDER_LIGHTS_INL_H_
#else
#define GLURAY_RENDER_LIGHTS_INL_H_
#endif

#include "render/integrators/points.inl.h"
#include "render/sampling/warp.inl.h"
#include "scene/light_source.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// A sample of a light as seen from a point, eye space.
struct TowardsLight {
  Float3 direction;  // unit length
  Float distance;    // to the light
  Float weight;      // its share of what the light gives, without surfaces and their cosine; 0: none
};

/// A direction about +z, uniform in the cone whose axis has cosine 1 - `rim` to its rim.
HWY_INLINE Float3 inCone(const Sample2& u, Float rim) {
  const FloatTag d;
  const Float k = hn::Mul(u.x, rim), radius = hn::Sqrt(hn::Max(hn::Mul(k, hn::Sub(splat(2), k)), splat(0))),
              angle = hn::Mul(u.y, splat(6.2831853f));
  return {hn::Mul(radius, hn::Cos(d, angle)), hn::Mul(radius, hn::Sin(d, angle)), hn::Sub(splat(1), k)};
}

/// 1 - cos of half an angle in degrees.
inline float rimOf(float degrees) {
  const double s = std::sin(static_cast<double>(degrees) * 0.017453292519943295 / 4);
  return static_cast<float>(2 * s * s);
}

/// 1 - sqrt(1 - s^2), precise for small s.
HWY_INLINE Float rimOfSine(Float s) {
  const Float square = hn::Mul(s, s), cosine = hn::Sqrt(hn::Max(hn::Sub(splat(1), square), splat(0)));
  return hn::Div(square, hn::Add(splat(1), cosine));
}

struct Way {
  Float3 direction;
  Float length;
};

/// The way between two points, of any length that a float can have.
HWY_INLINE Way wayOf(const Float3& v) {
  const Float largest = hn::Max(largestSize(v), splat(1e-37f));
  const Float3 small = scaled(v, hn::Div(splat(1), largest));
  const Float length = hn::Sqrt(hn::Max(dot(small, small), splat(1e-30f)));
  return {scaled(small, hn::Div(splat(1), length)), hn::Mul(largest, length)};
}

/// A ball that shines, which is so large that it fills a cone.
HWY_INLINE TowardsLight towardsBall(const Way& way, Float sine, const Sample2& u) {
  const Float3 local = inCone(u, rimOfSine(sine));
  // Along the ray, the ball begins where a line through a circle meets it.
  const Float across = hn::MulAdd(local.x, local.x, hn::Mul(local.y, local.y));
  const Float depth = hn::Sqrt(hn::Max(hn::NegMulAdd(splat(1), across, hn::Mul(sine, sine)), splat(0)));
  const Float end = hn::Mul(way.length, hn::Max(hn::Sub(local.z, depth), splat(0)));
  return {aboveSurface(way.direction, local), end, splat(1)};
}

/// A point of an area of the given middle.
HWY_INLINE TowardsLight towardsArea(const scene::LightSource& light, const Float3& toMiddle,
                                    const Float3& fromMiddle) {
  const Way way = wayOf(add(toMiddle, fromMiddle)), middle = wayOf(toMiddle);
  // A sample at the point itself weighs much, not infinitely much.
  const Float nearness = hn::Min(hn::Div(middle.length, way.length), splat(1e3f));
  const Float cosine = hn::Max(hn::Neg(dot(way.direction, splat(light.direction))), splat(0));
  return {way.direction, way.length, hn::Mul(cosine, hn::Mul(nearness, nearness))};
}

/// A sample of the light from points p. `size`: degrees, of lights that have none of their own.
HWY_INLINE TowardsLight towardsLight(const scene::LightSource& light, float size, const Float3& p,
                                     const Sample2& u) {
  using Kind = scene::LightSource::Kind;
  if (light.kind == Kind::distant) {
    const Float rim = splat(rimOf(light.angle > 0 ? light.angle : size));
    return {aboveSurface(splat(-light.direction), inCone(u, rim)),
            splat(std::numeric_limits<float>::infinity()), splat(1)};
  }
  const Float3 toMiddle = sub(splat(light.position), p);
  if (light.kind == Kind::rectangle) {
    const Float a = hn::MulSub(splat(2), u.x, splat(1)), b = hn::MulSub(splat(2), u.y, splat(1));
    return towardsArea(light, toMiddle,
                       add(scaled(splat(light.halfEdge[0]), a), scaled(splat(light.halfEdge[1]), b)));
  }
  if (light.kind == Kind::disc) {
    const FloatTag d;
    const Float radius = hn::Mul(hn::Sqrt(u.x), splat(light.radius)), angle = hn::Mul(u.y, splat(6.2831853f));
    const Float3 flat{hn::Mul(radius, hn::Cos(d, angle)), hn::Mul(radius, hn::Sin(d, angle)), splat(0)};
    return towardsArea(light, toMiddle, aboveSurface(splat(light.direction), flat));
  }
  const Way way = wayOf(toMiddle);
  const Float sine = light.radius > 0
                         ? hn::Min(hn::Div(splat(light.radius), way.length), splat(1))
                         : splat(static_cast<float>(std::sin(size * 0.5 * 0.017453292519943295)));
  return towardsBall(way, sine, u);
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
