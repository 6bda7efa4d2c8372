// What earlier frames know of points: visibility at the place where the last frame saw them. Compiled once
// for each instruction set.
#if defined(GLURAY_RENDER_HISTORY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_HISTORY_INL_H_
#undef GLURAY_RENDER_HISTORY_INL_H_
#else
#define GLURAY_RENDER_HISTORY_INL_H_
#endif

#include "render/moving/moving_frame.h"
#include "render/moving/narrow_lanes.h"
#include "render/moving/visibility_pixels.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// A packet's visibility where it is known already. Lanes without samples know nothing.
struct Known {
  alignas(64) Row samples;
  Visibility visibility;
};

// The same surface: its point lies on the plane of the one sought, its normal is about the same. Or, of
// narrow round surfaces: its normal leads from its point to the axis of the one sought.
constexpr float kOnPlane = 0.7f;      // pixels; also from the axis
constexpr float kSameNormal = 0.85f;  // cosine

/// The four pixels of the earlier buffer about a position, and the plane on which they must lie.
struct Taps {
  Float column, row, right, upper;  // of the lower left one; weights of the right and upper ones
  Float3 normal;
  Float along;  // dot(normal, point)
};

/// Axes of narrow round surfaces, in the earlier eye space.
struct Axes {
  Float3 center, axis;
  Float radius;  // 0: none
};

/// The axes of the lanes from `i` on.
HWY_ATTR inline Axes axesAt(const Reprojection& r, const NarrowLanes& narrow, int i) {
  const glm::mat3 linear(r.earlierFromEye);
  const Float3 axis = load3(narrow.axis, i), turned = transform(linear, axis);
  const Float length = hn::Sqrt(dot(turned, turned));
  const Float inverse = hn::Div(splat(1), hn::Max(length, splat(1e-30f)));
  // Motions of the camera are the same in all directions: by an axis or, of balls, any direction.
  const float scale = std::sqrt(glm::dot(linear[0], linear[0]));
  return {transformPoint(r.earlierFromEye, load3(narrow.center, i)), scaled(turned, inverse),
          hn::Mul(load(narrow.radius + i), splat(scale))};
}

/// Whether the surface of an earlier point with that normal has the axis, up to `reach`.
HWY_INLINE auto isAbout(const Axes& axes, const Float3& point, const Float3& normal, Float reach) {
  const Float3 from = sub(sub(point, scaled(normal, axes.radius)), axes.center);
  const Float along = dot(from, axes.axis), square = hn::NegMulAdd(along, along, dot(from, from));
  return hn::And(hn::Gt(axes.radius, hn::Zero(FloatTag())), hn::Le(square, hn::Mul(reach, reach)));
}

/// Adds one of the four to the sums. `axes`: null: no surface is narrow.
HWY_ATTR inline void addTap(const MovingFrame& moving, const Taps& taps, const Axes* axes, int dx, int dy,
                            Float& weights, Float& samples, Float* sums) {
  const FloatTag d;
  const VisibilityBuffer& buffer = *moving.earlier;
  const PixelSpace& space = moving.earlierSpace;
  const Float x = hn::Add(taps.column, splat(static_cast<float>(dx))),
              y = hn::Add(taps.row, splat(static_cast<float>(dy)));
  const Float bilinear = hn::Mul(dx ? taps.right : hn::Sub(splat(1), taps.right),
                                 dy ? taps.upper : hn::Sub(splat(1), taps.upper));
  auto there = hn::And(hn::And(hn::Ge(x, hn::Zero(d)), hn::Lt(x, splat(static_cast<float>(buffer.width)))),
                       hn::And(hn::Ge(y, hn::Zero(d)), hn::Lt(y, splat(static_cast<float>(buffer.height)))));
  there = hn::And(there, hn::Gt(bilinear, splat(1e-3f)));
  const IntTag di;
  const Ints pixel = hn::IfThenElseZero(
      hn::RebindMask(di, there),
      hn::Add(hn::Mul(hn::ConvertTo(di, y), hn::Set(di, buffer.width)), hn::ConvertTo(di, x)));
  const Ints at = hn::ShiftLeft<1>(pixel);
  const VisibilityPixels p =
      VisibilityPixels::unpacked(hn::GatherIndex(WordTag(), buffer.words.data(), at),
                                 hn::GatherIndex(WordTag(), buffer.words.data() + 1, at));
  const auto at3 = [&](const glm::vec3& base, const glm::vec3& perX, const glm::vec3& perY) HWY_ATTR {
    return add(splat(base), add(scaled(splat(perX), x), scaled(splat(perY), y)));
  };
  const Float3 base = at3(space.base, space.baseX, space.baseY), ray = at3(space.ray, space.rayX, space.rayY);
  const Float off = hn::Sub(hn::MulAdd(p.depth, dot(taps.normal, ray), dot(taps.normal, base)), taps.along);
  const Float width = hn::MulAdd(p.depth, splat(space.perDepth), splat(space.pixel));
  there = hn::And(there, hn::Gt(p.samples, hn::Zero(d)));
  const Float reach = hn::Mul(width, splat(kOnPlane));
  auto same = hn::And(hn::Le(hn::Abs(off), reach), hn::Gt(dot(p.normal, taps.normal), splat(kSameNormal)));
  if (axes) same = hn::Or(same, isAbout(*axes, add(base, scaled(ray, p.depth)), p.normal, reach));
  there = hn::And(there, same);
  const Float weight = hn::IfThenElseZero(there, bilinear);
  weights = hn::Add(weights, weight);
  samples = hn::MulAdd(weight, p.samples, samples);
  sums[0] = hn::MulAdd(weight, p.first, sums[0]);
  sums[1] = hn::MulAdd(weight, p.second, sums[1]);
  for (size_t f = 0; f < buffer.more.size(); ++f) {
    alignas(64) int32_t index[kLanes];
    alignas(64) Row value;
    hn::Store(pixel, di, index);
    for (int i = 0; i < lanesOfVector(); ++i) value[i] = buffer.more[f][static_cast<size_t>(index[i])];
    sums[2 + f] =
        hn::MulAdd(weight, hn::Mul(load(value), splat(1 / VisibilityBuffer::kLargestMore)), sums[2 + f]);
  }
}

/// Looks up points and normals in eye space, of something that has not moved since.
HWY_ATTR inline void lookUp(const MovingFrame& moving, const Row (&point)[3], const Row (&normal)[3],
                            const NarrowLanes& narrow, Known& out) {
  const FloatTag d;
  const Reprojection& r = moving.reprojection;
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const Float3 now = load3(point, i);
    const glm::mat4& m = r.earlierPixelFromEye;
    const auto row = [&](int c) HWY_ATTR {
      return hn::MulAdd(splat(m[0][c]), now.x,
                        hn::MulAdd(splat(m[1][c]), now.y, hn::MulAdd(splat(m[2][c]), now.z, splat(m[3][c]))));
    };
    const Float inverseW = hn::Div(splat(1), row(3));
    // What lies behind the viewer or is no number is far outside.
    const auto position = [&](int c) HWY_ATTR {
      const Float p = hn::Mul(row(c), inverseW);
      const auto usable = hn::And(hn::Gt(inverseW, hn::Zero(d)), hn::Le(hn::Abs(p), splat(1e6f)));
      return hn::IfThenElse(usable, p, splat(-9));
    };
    const Float x = position(0), y = position(1);
    Taps taps;
    taps.column = hn::Floor(x), taps.row = hn::Floor(y);
    taps.right = hn::Sub(x, taps.column), taps.upper = hn::Sub(y, taps.row);
    taps.normal = unit(transform(r.earlierFromEyeNormal, load3(normal, i)));
    taps.along = dot(taps.normal, transformPoint(r.earlierFromEye, now));
    Axes axes;
    if (narrow.any) axes = axesAt(r, narrow, i);
    Float weights = hn::Zero(d), samples = weights;
    Float sums[std::max(Channels::kMax, 2)];
    for (Float& sum : sums) sum = weights;
    for (int tap = 0; tap < 4; ++tap)
      addTap(moving, taps, narrow.any ? &axes : nullptr, tap & 1, tap >> 1, weights, samples, sums);
    const auto known = hn::Gt(weights, splat(0.05f));
    const Float inverse = hn::IfThenElseZero(known, hn::Div(splat(1), hn::Max(weights, splat(0.05f))));
    store(hn::Min(hn::Mul(samples, inverse), splat(moving.mostSamples)), out.samples + i);
    for (int f = 0; f < moving.channels.count(); ++f)
      store(hn::Mul(sums[f], inverse), moving.channels.rowOf(out.visibility, f) + i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
