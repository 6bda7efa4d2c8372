// Blending of colours that a framebuffer of eight bits a channel holds (GL 2.1, 4.1.8). Part of kernels.cpp
// (compiled once for each instruction set).
#if defined(GLURAY_RENDER_BLEND_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_BLEND_INL_H_
#undef GLURAY_RENDER_BLEND_INL_H_
#else
#define GLURAY_RENDER_BLEND_INL_H_
#endif

#include "render/fragment_inputs.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// A fragment's colour and the framebuffer's, in [0, 1].
struct BlendInput {
  Float source[4], there[4];
};

HWY_INLINE Float oneMinus(Float v) { return hn::Sub(splat(1), v); }

/// What a factor is for channel c.
HWY_ATTR inline Float blendFactor(scene::BlendFactor factor, const BlendInput& in, const glm::vec4& constant,
                                  int c) {
  using Factor = scene::BlendFactor;
  switch (factor) {
    case Factor::zero: return splat(0);
    case Factor::one: return splat(1);
    case Factor::sourceColor: return in.source[c];
    case Factor::oneMinusSourceColor: return oneMinus(in.source[c]);
    case Factor::sourceAlpha: return in.source[3];
    case Factor::oneMinusSourceAlpha: return oneMinus(in.source[3]);
    case Factor::destinationAlpha: return in.there[3];
    case Factor::oneMinusDestinationAlpha: return oneMinus(in.there[3]);
    case Factor::destinationColor: return in.there[c];
    case Factor::oneMinusDestinationColor: return oneMinus(in.there[c]);
    case Factor::sourceAlphaSaturate: return c == 3 ? splat(1) : hn::Min(in.source[3], oneMinus(in.there[3]));
    case Factor::constantColor: return splat(constant[c]);
    case Factor::oneMinusConstantColor: return splat(1 - constant[c]);
    case Factor::constantAlpha: return splat(constant.a);
    case Factor::oneMinusConstantAlpha: return splat(1 - constant.a);
  }
  return splat(1);
}

/// Channel c of the result, rounded to eight bits.
HWY_ATTR inline Float blendChannel(const scene::Blending& blending, const BlendInput& in, int c) {
  const scene::Blending::Part& part = c < 3 ? blending.rgb : blending.alpha;
  const Float s = in.source[c], d = in.there[c];
  const auto weighted = [&](Float v, scene::BlendFactor factor)
                            HWY_ATTR { return hn::Mul(v, blendFactor(factor, in, blending.constant, c)); };
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
  return hn::Mul(hn::Round(hn::Mul(clamp01(combined()), splat(255))), splat(1.0f / 255));
}

/// Blends RGBA8 colours `source` with the rows `there` in `lanes`, in the channels that are written.
HWY_ATTR inline void blendRows(const scene::Blending& blending, const scene::ColorWrites& writes,
                               uint32_t lanes, const uint32_t* source, Row (&there)[4]) {
  const hn::Rebind<uint32_t, FloatTag> du;
  const hn::Rebind<int32_t, FloatTag> di;
  const bool written[] = {writes.red, writes.green, writes.blue, writes.alpha && blending.hasAlpha};
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const auto bits = hn::Load(du, source + i);
    const auto channel = [&](auto shifted) HWY_ATTR {
      const auto byte = hn::And(shifted, hn::Set(du, 255));
      return hn::Mul(hn::ConvertTo(FloatTag(), hn::BitCast(di, byte)), splat(1.0f / 255));
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
