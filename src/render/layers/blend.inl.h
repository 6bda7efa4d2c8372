// Blending in a framebuffer with eight bits per channel (GL 2.1, 4.1.8). Part of kernels.cpp (compiled once
// for each instruction set).
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

/// The fragment's and the framebuffer's colours: integers from 0 to 255.
struct BlendInput {
  Float source[4], there[4];
};

HWY_INLINE Float oneMinus(Float v) { return hn::Sub(splat(255), v); }

HWY_INLINE Float byteOf(float value) { return splat(std::round(value * 255)); }

/// a * b / 255, rounded as in Mesa's rasteriser (lp_build_mul_norm): of 65,536 products 24 are one less than
/// the nearest. OpenGL leaves the rounding open, but differences would add up over many thin layers.
HWY_INLINE Float productOf(Float a, Float b) {
  const Float product = hn::Mul(a, b), share = splat(1.0f / 256);
  const Float more = hn::Add(hn::Floor(hn::Mul(product, share)), splat(128));
  return hn::Floor(hn::Mul(hn::Add(product, more), share));
}

/// The value of a blend factor for channel c.
HWY_ATTR inline Float blendFactor(scene::BlendFactor factor, const BlendInput& in, const glm::vec4& constant,
                                  int c) {
  using Factor = scene::BlendFactor;
  switch (factor) {
    case Factor::zero: return splat(0);
    case Factor::one: return splat(255);
    case Factor::sourceColor: return in.source[c];
    case Factor::oneMinusSourceColor: return oneMinus(in.source[c]);
    case Factor::sourceAlpha: return in.source[3];
    case Factor::oneMinusSourceAlpha: return oneMinus(in.source[3]);
    case Factor::destinationAlpha: return in.there[3];
    case Factor::oneMinusDestinationAlpha: return oneMinus(in.there[3]);
    case Factor::destinationColor: return in.there[c];
    case Factor::oneMinusDestinationColor: return oneMinus(in.there[c]);
    case Factor::sourceAlphaSaturate:
      return c == 3 ? splat(255) : hn::Min(in.source[3], oneMinus(in.there[3]));
    case Factor::constantColor: return byteOf(constant[c]);
    case Factor::oneMinusConstantColor: return oneMinus(byteOf(constant[c]));
    case Factor::constantAlpha: return byteOf(constant.a);
    case Factor::oneMinusConstantAlpha: return oneMinus(byteOf(constant.a));
  }
  return splat(255);
}

/// Channel c of the result.
HWY_ATTR inline Float blendChannel(const scene::Blending& blending, const BlendInput& in, int c) {
  const scene::Blending::Part& part = c < 3 ? blending.rgb : blending.alpha;
  const Float s = in.source[c], d = in.there[c];
  const auto weighted = [&](Float v, scene::BlendFactor factor)
                            HWY_ATTR { return productOf(v, blendFactor(factor, in, blending.constant, c)); };
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
  return hn::Clamp(combined(), splat(0), splat(255));
}

/// Blends RGBA8 colours `source` into the rows `there`, from 0 to 255, in `lanes` and in the written
/// channels.
HWY_ATTR inline void blendRows(const scene::Blending& blending, const scene::ColorWrites& writes,
                               uint32_t lanes, const uint32_t* source, Row (&there)[4]) {
  const hn::Rebind<uint32_t, FloatTag> du;
  const hn::Rebind<int32_t, FloatTag> di;
  const bool written[] = {writes.red, writes.green, writes.blue, writes.alpha && blending.hasAlpha};
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const auto bits = hn::Load(du, source + i);
    const auto channel = [&](auto shifted) HWY_ATTR {
      const auto byte = hn::And(shifted, hn::Set(du, 255));
      return hn::ConvertTo(FloatTag(), hn::BitCast(di, byte));
    };
    BlendInput in{{channel(bits), channel(hn::ShiftRight<8>(bits)), channel(hn::ShiftRight<16>(bits)),
                   channel(hn::ShiftRight<24>(bits))},
                  {load(there[0] + i), load(there[1] + i), load(there[2] + i), load(there[3] + i)}};
    for (int c = 0; c < 4; ++c) {
      if (!written[c]) continue;
      store(hn::IfThenElse(lanesAt(lanes, i), blendChannel(blending, in, c), in.there[c]), there[c] + i);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
