// Pixels of a visibility buffer, packed and unpacked. Compiled once for each instruction set.
#if defined(GLURAY_RENDER_VISIBILITY_PIXELS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_VISIBILITY_PIXELS_INL_H_
#undef GLURAY_RENDER_VISIBILITY_PIXELS_INL_H_
#else
#define GLURAY_RENDER_VISIBILITY_PIXELS_INL_H_
#endif

#include "render/local/fragment.inl.h"
#include "render/moving/visibility_buffer.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

using WordTag = hn::Rebind<uint32_t, FloatTag>;
using IntTag = hn::Rebind<int32_t, FloatTag>;
using Words = hn::Vec<WordTag>;
using Ints = hn::Vec<IntTag>;

HWY_INLINE Words splatWord(uint32_t v) { return hn::Set(WordTag(), v); }
HWY_INLINE Float toFloat(Words v) { return hn::ConvertTo(FloatTag(), hn::BitCast(IntTag(), v)); }
/// Of numbers >= 0.
HWY_INLINE Words toWord(Float v) { return hn::BitCast(WordTag(), hn::NearestInt(v)); }

// Depths are floats in [2^-31, 2), of which 5 bits of the exponent and 15 of the mantissa are kept.
constexpr uint32_t kMinDepth = 0x30000000u;  // 2^-31

HWY_INLINE Words packDepth(Float depth) {
  const Float inside = hn::Min(hn::Max(depth, splat(0x1p-31f)), splat(1.9999f));
  return hn::ShiftRight<8>(hn::Sub(hn::BitCast(WordTag(), inside), splatWord(kMinDepth)));
}
HWY_INLINE Float unpackDepth(Words code) {
  const Words middle = hn::Or(hn::ShiftLeft<8>(code), splatWord(0x80u));
  return hn::BitCast(FloatTag(), hn::Add(middle, splatWord(kMinDepth)));
}

/// A unit vector as a point of the octahedron, unfolded (Q. Meyer and others, "On Floating-Point Normal
/// Vectors", 2010): 7 bits for each coordinate.
HWY_INLINE Words packNormal(const Float3& n) {
  const FloatTag d;
  const Float sum = hn::Add(hn::Abs(n.x), hn::Add(hn::Abs(n.y), hn::Abs(n.z)));
  const Float inverse = hn::Div(splat(1), hn::Max(sum, splat(1e-6f)));
  const Float x = hn::Mul(n.x, inverse), y = hn::Mul(n.y, inverse);
  const auto below = hn::Lt(n.z, hn::Zero(d));
  const Float foldedX = hn::CopySign(hn::Sub(splat(1), hn::Abs(y)), x),
              foldedY = hn::CopySign(hn::Sub(splat(1), hn::Abs(x)), y);
  const auto code = [](Float v) HWY_ATTR {
    const Float inside = hn::Min(hn::Max(v, splat(-1)), splat(1));
    return toWord(hn::MulAdd(inside, splat(63), splat(63)));
  };
  return hn::Or(hn::ShiftLeft<7>(code(hn::IfThenElse(below, foldedX, x))),
                code(hn::IfThenElse(below, foldedY, y)));
}
HWY_INLINE Float3 unpackNormal(Words code) {
  const FloatTag d;
  const auto coordinate = [](Words v) HWY_ATTR {
    return hn::MulAdd(toFloat(hn::And(v, splatWord(127))), splat(1.0f / 63), splat(-1));
  };
  const Float x = coordinate(hn::ShiftRight<7>(code)), y = coordinate(code);
  const Float z = hn::Sub(splat(1), hn::Add(hn::Abs(x), hn::Abs(y)));
  const Float fold = hn::Max(hn::Neg(z), hn::Zero(d));
  return unit({hn::Sub(x, hn::CopySign(fold, x)), hn::Sub(y, hn::CopySign(fold, y)), z});
}

HWY_INLINE Words packVisibility(Float v) {
  return toWord(hn::Mul(clamp01(v), splat(VisibilityBuffer::kLargest)));
}

/// Pixels of the buffer, as many as a vector has lanes.
struct VisibilityPixels {
  Float depth, samples, first, second;
  Float3 normal;

  HWY_INLINE Words word0() const {
    return hn::Or(hn::ShiftLeft<12>(packDepth(depth)), packVisibility(first));
  }
  HWY_INLINE Words word1() const {
    const Words count = hn::ShiftLeft<12>(toWord(samples));
    return hn::Or(hn::Or(hn::ShiftLeft<18>(packNormal(normal)), count), packVisibility(second));
  }
  static HWY_INLINE VisibilityPixels unpacked(Words word0, Words word1) {
    const Words mask = splatWord(4095);
    const float scale = 1 / VisibilityBuffer::kLargest;
    return {unpackDepth(hn::ShiftRight<12>(word0)),
            toFloat(hn::And(hn::ShiftRight<12>(word1), splatWord(VisibilityBuffer::kMaxSamples))),
            hn::Mul(toFloat(hn::And(word0, mask)), splat(scale)),
            hn::Mul(toFloat(hn::And(word1, mask)), splat(scale)), unpackNormal(hn::ShiftRight<18>(word1))};
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
