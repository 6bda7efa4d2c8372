// Blending in a framebuffer with eight bits per channel, or with floats (GL 2.1, 4.1.8; GL 3.0, 4.1.7). Part
// of kernels.cpp (compiled once for each instruction set).
#if defined(GLURAY_RENDER_BLEND_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_BLEND_INL_H_
#undef GLURAY_RENDER_BLEND_INL_H_
#else
#define GLURAY_RENDER_BLEND_INL_H_
#endif

#include "render/shading/fragment_inputs.inl.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// The fragment's and the framebuffer's colours.
struct BlendInput {
  Float source[4], there[4];
};

/// Channels of eight bits: integers from 0 to 255.
struct ByteChannels {
  static constexpr float kOne = 255;
  static HWY_INLINE Float constant(float value) { return splat(std::round(value * 255)); }
  /// a * b / 255, rounded as in Mesa's rasteriser (lp_build_mul_norm): of 65,536 products 24 are one less
  /// than the nearest. OpenGL leaves the rounding open, but differences would add up over many thin layers.
  static HWY_INLINE Float product(Float a, Float b) {
    const Float product = hn::Mul(a, b), share = splat(1.0f / 256);
    const Float more = hn::Add(hn::Floor(hn::Mul(product, share)), splat(128));
    return hn::Floor(hn::Mul(hn::Add(product, more), share));
  }
  static HWY_INLINE Float stored(Float v) { return hn::Clamp(v, splat(0), splat(255)); }
};

/// Channels of floats, which are not clamped.
struct FloatChannels {
  static constexpr float kOne = 1;
  static HWY_INLINE Float constant(float value) { return splat(value); }
  static HWY_INLINE Float product(Float a, Float b) { return hn::Mul(a, b); }
  static HWY_INLINE Float stored(Float v) { return v; }
};

/// Channels of floats of 16 bits. They are rounded towards 0, as Mesa's rasteriser does
/// (lp_build_float_to_half); OpenGL leaves the rounding open.
struct HalfChannels : FloatChannels {
  static HWY_INLINE Float stored(Float v) {
    const hn::Rebind<uint32_t, FloatTag> du;
    constexpr float kLargest = 65504, kLeastNormal = 0x1p-14f, kLeast = 0x1p-24f;
    const Float size = hn::Min(hn::Abs(v), splat(kLargest));
    const auto bits = hn::And(hn::BitCast(du, size), hn::Set(du, 0xffffe000u));
    const Float normal = hn::BitCast(FloatTag(), bits);
    const Float small = hn::Mul(hn::Floor(hn::Mul(size, splat(1 / kLeast))), splat(kLeast));
    return hn::CopySign(hn::IfThenElse(hn::Lt(size, splat(kLeastNormal)), small, normal), v);
  }
};

template <class Channels>
HWY_INLINE Float oneMinus(Float v) {
  return hn::Sub(splat(Channels::kOne), v);
}

/// The value of a blend factor for channel c.
template <class Channels>
HWY_ATTR inline Float blendFactor(scene::BlendFactor factor, const BlendInput& in, const glm::vec4& constant,
                                  int c) {
  using Factor = scene::BlendFactor;
  switch (factor) {
    case Factor::zero: return splat(0);
    case Factor::one: return splat(Channels::kOne);
    case Factor::sourceColor: return in.source[c];
    case Factor::oneMinusSourceColor: return oneMinus<Channels>(in.source[c]);
    case Factor::sourceAlpha: return in.source[3];
    case Factor::oneMinusSourceAlpha: return oneMinus<Channels>(in.source[3]);
    case Factor::destinationAlpha: return in.there[3];
    case Factor::oneMinusDestinationAlpha: return oneMinus<Channels>(in.there[3]);
    case Factor::destinationColor: return in.there[c];
    case Factor::oneMinusDestinationColor: return oneMinus<Channels>(in.there[c]);
    case Factor::sourceAlphaSaturate:
      return c == 3 ? splat(Channels::kOne) : hn::Min(in.source[3], oneMinus<Channels>(in.there[3]));
    case Factor::constantColor: return Channels::constant(constant[c]);
    case Factor::oneMinusConstantColor: return oneMinus<Channels>(Channels::constant(constant[c]));
    case Factor::constantAlpha: return Channels::constant(constant.a);
    case Factor::oneMinusConstantAlpha: return oneMinus<Channels>(Channels::constant(constant.a));
  }
  return splat(Channels::kOne);
}

/// Channel c of the result.
template <class Channels>
HWY_ATTR inline Float blendChannel(const scene::Blending& blending, const BlendInput& in, int c) {
  const scene::Blending::Part& part = c < 3 ? blending.rgb : blending.alpha;
  const Float s = in.source[c], d = in.there[c];
  const auto weighted = [&](Float v, scene::BlendFactor factor) HWY_ATTR {
    return Channels::product(v, blendFactor<Channels>(factor, in, blending.constant, c));
  };
  const auto combined = [&]() HWY_ATTR {
    switch (part.equation) {
      case scene::BlendEquation::min: return hn::Min(s, d);
      case scene::BlendEquation::max: return hn::Max(s, d);
      case scene::BlendEquation::subtract:
        return hn::Sub(weighted(s, part.source), weighted(d, part.destination));
      case scene::BlendEquation::reverseSubtract:
        return hn::Sub(weighted(d, part.destination), weighted(s, part.source));
      case scene::BlendEquation::add: break;
    }
    return hn::Add(weighted(s, part.source), weighted(d, part.destination));
  };
  return Channels::stored(combined());
}

/// Channels that blending changes.
struct WrittenChannels {
  bool of[4];
  WrittenChannels(const scene::Blending& blending, const scene::ColorWrites& writes)
      : of{writes.red, writes.green, writes.blue, writes.alpha && blending.hasAlpha} {}
};

/// Blends `in`, the vector that begins at lane i, into the rows `there` in `lanes`.
template <class Channels>
HWY_ATTR inline void blendVector(const scene::Blending& blending, const WrittenChannels& written,
                                 uint32_t lanes, int i, const BlendInput& in, Row (&there)[4]) {
  for (int c = 0; c < 4; ++c)
    if (written.of[c])
      store(hn::IfThenElse(lanesAt(lanes, i), blendChannel<Channels>(blending, in, c), in.there[c]),
            there[c] + i);
}

/// Blends RGBA8 colours `source` into the rows `there`, from 0 to 255, in `lanes` and in the written
/// channels.
HWY_ATTR inline void blendRows(const scene::Blending& blending, const scene::ColorWrites& writes,
                               uint32_t lanes, const uint32_t* source, Row (&there)[4]) {
  const hn::Rebind<uint32_t, FloatTag> du;
  const hn::Rebind<int32_t, FloatTag> di;
  const WrittenChannels written(blending, writes);
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const auto bits = hn::Load(du, source + i);
    const auto channel = [&](auto shifted) HWY_ATTR {
      const auto byte = hn::And(shifted, hn::Set(du, 255));
      return hn::ConvertTo(FloatTag(), hn::BitCast(di, byte));
    };
    const BlendInput in{{channel(bits), channel(hn::ShiftRight<8>(bits)), channel(hn::ShiftRight<16>(bits)),
                         channel(hn::ShiftRight<24>(bits))},
                        {load(there[0] + i), load(there[1] + i), load(there[2] + i), load(there[3] + i)}};
    blendVector<ByteChannels>(blending, written, lanes, i, in, there);
  }
}

/// The same for floats.
template <class Channels>
HWY_ATTR inline void blendFloats(const scene::Blending& blending, const scene::ColorWrites& writes,
                                 uint32_t lanes, const Row (&source)[4], Row (&there)[4]) {
  const WrittenChannels written(blending, writes);
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const BlendInput in{{load(source[0] + i), load(source[1] + i), load(source[2] + i), load(source[3] + i)},
                        {load(there[0] + i), load(there[1] + i), load(there[2] + i), load(there[3] + i)}};
    blendVector<Channels>(blending, written, lanes, i, in, there);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
