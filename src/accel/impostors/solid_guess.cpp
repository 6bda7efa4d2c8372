#include "accel/impostors/solid_guess.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "accel/impostors/solid_guess.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// What follows is included once for each instruction set, after Highway's macros.
#include "accel/impostors/lanes.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::accel {
namespace HWY_NAMESPACE {

HWY_INLINE Float3 scaled(const Float3& v, Float s) {
  return {hn::Mul(v.x, s), hn::Mul(v.y, s), hn::Mul(v.z, s)};
}
HWY_INLINE Float largestOf(const Float3& v) {
  return hn::Max(hn::Abs(v.x), hn::Max(hn::Abs(v.y), hn::Abs(v.z)));
}
HWY_INLINE Float3 mapped(const glm::mat4& m, const Float3& v) {
  const auto row = [&](int r) HWY_ATTR {
    return hn::MulAdd(splat(m[0][r]), v.x, hn::MulAdd(splat(m[1][r]), v.y, hn::Mul(splat(m[2][r]), v.z)));
  };
  return {row(0), row(1), row(2)};
}

/// A hull about its middle, in units of its size, so that squares of lengths neither overflow nor vanish.
struct Hull {
  float perSize;
  glm::vec3 middle, axis{0};
  float half = 0, radius[2], sine = 0, cosine = 1, largest;
  float mapError, placeError;  // of points: of the map from object space, for length 1; of all

  Hull(const PlacedImpostors& placed, const RoundHull& hull) {
    constexpr float kRounding = 1e-6f;
    const glm::vec3 line = hull.end[1] - hull.end[0];
    const float widest = std::max({std::abs(line.x), std::abs(line.y), std::abs(line.z)});
    largest = std::max(hull.radius[0], hull.radius[1]);
    float length = 0;
    if (widest > 0) {
      const glm::vec3 small = line / widest;
      const float shape = std::sqrt(glm::dot(small, small));
      length = widest * shape, axis = small / shape;
    }
    perSize = 1 / (0.5f * length + largest);
    middle = 0.5f * (hull.end[0] + hull.end[1]);
    half = 0.5f * length * perSize, largest *= perSize;
    for (int k = 0; k < 2; ++k) radius[k] = hull.radius[k] * perSize;
    if (half > 0) sine = (radius[0] - radius[1]) / (2 * half), cosine = std::sqrt(1 - sine * sine);
    const glm::mat4& m = placed.lightingFromObject;
    float linear = 0, offset = 0;
    for (int r = 0; r < 3; ++r) {
      offset += std::abs(m[3][r]) + std::abs(middle[r]);
      for (int c = 0; c < 3; ++c) linear = std::max(linear, std::abs(m[c][r]));
    }
    mapError = kRounding * linear, placeError = kRounding * offset;
  }
  /// A cone of which hits are guessed.
  bool isSlender() const { return half > 0 && std::abs(sine) < 0.5f; }
};

/// Rays of unit length about a hull's middle, from the points nearest to that.
struct Rays {
  Float3 from, dir;
  Float tNear, tFar;  // from there
  Float error;        // of `from`
};

HWY_INLINE Rays raysAbout(const PlacedImpostors& placed, const Hull& hull, const float (*rows)[kLanes],
                          int i) {
  const Float perSize = splat(hull.perSize);
  const Float3 org{load(rows[0] + i), load(rows[1] + i), load(rows[2] + i)},
      dir{load(rows[4] + i), load(rows[5] + i), load(rows[6] + i)};
  const glm::mat4& m = placed.lightingFromObject;
  const Float3 start = mapped(m, org), way = mapped(m, dir);
  const auto about = [&](Float v, int axis) HWY_ATTR {
    return hn::Mul(hn::Add(v, hn::Sub(splat(m[3][axis]), splat(hull.middle[axis]))), perSize);
  };
  Rays r;
  const Float3 from{about(start.x, 0), about(start.y, 1), about(start.z, 2)};
  const Float longest = largestOf(way);
  const Float3 small = scaled(way, hn::Div(splat(1), longest));
  const Float shape = hn::Sqrt(dot(small, small));
  r.dir = scaled(small, hn::Div(splat(1), shape));
  const Float nearest = hn::Neg(dot(from, r.dir));
  r.from = along(from, nearest, r.dir);
  const Float length = hn::Mul(hn::Mul(longest, shape), perSize);
  r.tNear = hn::NegMulAdd(nearest, splat(1), hn::Mul(load(rows[3] + i), length));
  r.tFar = hn::Sub(hn::Mul(load(rows[8] + i), length), nearest);
  // What rounding may have moved the origin by, and the point nearest to the middle because of the direction.
  const Float ofOrigin =
      hn::Mul(hn::MulAdd(splat(3 * hull.mapError), largestOf(org), splat(hull.placeError)), perSize);
  const Float turned = hn::Div(hn::Mul(splat(3 * hull.mapError), largestOf(dir)), longest);
  const Float away = hn::Add(largestOf(from), hn::Abs(nearest));
  r.error = hn::Add(splat(2e-6f), hn::MulAdd(away, hn::Add(turned, splat(2e-6f)), ofOrigin));
  return r;
}

HWY_INLINE uint32_t bitsOf(Mask mask, int i) {
  uint8_t bits[8] = {};
  hn::StoreMaskBits(Tag(), mask, bits);
  return (bits[0] | static_cast<uint32_t>(bits[1]) << 8) << i;
}

/// Whether t is surely within the ray.
HWY_INLINE Mask isWithin(const Rays& r, Float t, Float error) {
  return hn::And(hn::Ge(t, hn::Add(r.tNear, error)), hn::Le(t, hn::Sub(r.tFar, error)));
}

/// Surely beside the hull, or before or behind it.
HWY_INLINE Mask misses(const Hull& hull, const Rays& r) {
  const Float n2 = dot(r.from, r.from), reach = hn::Add(splat(1), r.error);
  Mask missed = hn::Gt(n2, hn::Mul(reach, hn::Mul(reach, splat(1.00001f))));
  missed = hn::Or(missed, hn::Or(hn::Gt(r.tNear, reach), hn::Lt(r.tFar, hn::Neg(reach))));
  if (hull.half == 0) return missed;
  // The distance of the lines, times the sine of the angle between them.
  const Float3 d = r.dir, a{splat(hull.axis.x), splat(hull.axis.y), splat(hull.axis.z)};
  const Float3 across{hn::MulSub(a.y, d.z, hn::Mul(a.z, d.y)), hn::MulSub(a.z, d.x, hn::Mul(a.x, d.z)),
                      hn::MulSub(a.x, d.y, hn::Mul(a.y, d.x))};
  const Float sine = hn::Sqrt(dot(across, across));
  const Float apart = hn::Abs(dot(r.from, across)),
              limit = hn::MulAdd(hn::Add(splat(hull.largest), r.error), sine, splat(1e-5f));
  return hn::Or(missed, hn::Gt(apart, limit));
}

/// Surely meets the ball.
HWY_INLINE Mask meetsBall(const Hull& hull, const Rays& r, bool leaves) {
  const float radius = hull.largest;
  const Float d = hn::Sub(splat(radius * radius), dot(r.from, r.from));
  const Float half = hn::Sqrt(hn::Max(d, hn::Zero(Tag()))), error = hn::Mul(r.error, splat(16));
  const Mask inside =
      hn::And(hn::Ge(d, splat(0.04f * radius * radius)), hn::Le(error, splat(0.05f * radius)));
  Mask met = isWithin(r, hn::Neg(half), error);
  if (leaves) met = hn::Or(met, isWithin(r, half, error));
  return hn::And(inside, met);
}

/// Surely meets the cone between the circles where it touches the balls; where a line first meets that, it
/// enters the hull. In coordinates along and across the axis, |aside + t*across| = radius + slope*place.
HWY_INLINE Mask meetsCone(const Hull& hull, const Rays& r) {
  const float slope = -hull.sine / hull.cosine, thinnest = std::min(hull.radius[0], hull.radius[1]);
  const Float3 axis{splat(hull.axis.x), splat(hull.axis.y), splat(hull.axis.z)};
  const Float start = dot(axis, r.from), dirZ = dot(axis, r.dir);
  const Float3 aside = along(r.from, hn::Neg(start), axis), across = along(r.dir, hn::Neg(dirZ), axis);
  const Float a = dot(across, across), b = dot(aside, across);
  const Float s = hn::Neg(hn::Div(b, a));
  const Float3 nearest = along(aside, s, across);
  const Float n2 = dot(nearest, nearest), q = hn::Mul(splat(slope), dirZ);
  const Float place = hn::MulAdd(s, dirZ, start);
  const Float middle = splat(0.5f * (hull.radius[0] + hull.radius[1]) / hull.cosine);
  const Float radius = hn::MulAdd(splat(slope), place, middle);
  const Float discriminant = hn::MulAdd(a, hn::MulSub(radius, radius, n2), hn::Mul(hn::Mul(q, q), n2));
  const Float root = hn::Sqrt(hn::Max(discriminant, hn::Zero(Tag())));
  const Float scale = hn::Div(splat(1), hn::NegMulAdd(q, q, a));
  const Float enter = hn::MulAdd(hn::MulSub(radius, q, root), scale, s);
  const Float at = hn::MulAdd(enter, dirZ, start);
  // Steep lines alone, well within the cone's width: then errors of roots are few times those of points.
  const Float error = hn::Mul(r.error, splat(64));
  Mask sure = hn::And(hn::Ge(a, splat(0.2f)), hn::Le(error, splat(0.25f * thinnest)));
  sure = hn::And(sure, hn::Ge(discriminant, hn::Mul(hn::Mul(radius, radius), hn::Mul(a, splat(0.04f)))));
  const float lowest = -hull.half + hull.radius[0] * hull.sine,
              highest = hull.half + hull.radius[1] * hull.sine;
  sure = hn::And(
      sure, hn::And(hn::Ge(at, hn::Add(splat(lowest), error)), hn::Le(at, hn::Sub(splat(highest), error))));
  return hn::And(sure, isWithin(r, enter, error));
}

SolidGuess guessLanes(const PlacedImpostors& placed, const RoundHull& round, const float* rays,
                      unsigned count, uint32_t lanes) {
  constexpr int kRows = 9;
  alignas(64) float rows[kRows][kLanes];
  for (int row = 0; row < kRows; ++row)
    if (row != 7) std::memcpy(rows[row], rays + static_cast<size_t>(row) * count, count * sizeof(float));
  const Hull hull(placed, round);
  SolidGuess guess;
  for (int i = 0; i < static_cast<int>(count); i += width()) {
    if (!(lanes >> i & ((1u << width()) - 1))) continue;
    const Rays r = raysAbout(placed, hull, rows, i);
    guess.misses |= bitsOf(misses(hull, r), i);
    if (!round.whole) continue;
    if (hull.half == 0)
      guess.hits |= bitsOf(meetsBall(hull, r, round.leaves), i);
    else if (hull.isSlender())
      guess.hits |= bitsOf(meetsCone(hull, r), i);
  }
  guess.misses &= lanes, guess.hits &= lanes & ~guess.misses;
  return guess;
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::accel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gluray::accel {

HWY_EXPORT(guessLanes);

SolidGuess guessSolid(const PlacedImpostors& placed, const RoundHull& hull, const float* rays, unsigned count,
                      uint32_t lanes) {
  return HWY_DYNAMIC_DISPATCH(guessLanes)(placed, hull, rays, count, lanes);
}

}  // namespace gluray::accel
#endif
