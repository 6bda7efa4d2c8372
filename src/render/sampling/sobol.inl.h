// Points of Sobol's sequence in two dimensions, scrambled as Owen does it: every power of two of them from
// the beginning is stratified, and blocks of pixels with different seeds get independent ones (B. Burley,
// "Practical Hash-based Owen Scrambling", 2020). Compiled once for each instruction set.
#if defined(GLURAY_RENDER_SOBOL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_SOBOL_INL_H_
#undef GLURAY_RENDER_SOBOL_INL_H_
#else
#define GLURAY_RENDER_SOBOL_INL_H_
#endif

#include "render/local/fragment.inl.h"
#include "render/sampling/sobol.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

using BitsTag = hn::Rebind<uint32_t, FloatTag>;
using Bits = hn::Vec<BitsTag>;

HWY_INLINE Bits splatBits(uint32_t v) { return hn::Set(BitsTag(), v); }

/// A hash of 32 bits in which every bit of the input changes every bit of the output (C. Wellons,
/// "lowbias32").
HWY_INLINE Bits hashed(Bits x) {
  x = hn::Mul(hn::Xor(x, hn::ShiftRight<16>(x)), splatBits(0x7feb352du));
  x = hn::Mul(hn::Xor(x, hn::ShiftRight<15>(x)), splatBits(0x846ca68bu));
  return hn::Xor(x, hn::ShiftRight<16>(x));
}

HWY_INLINE Bits reversed(Bits x) {
  const auto swap = [](Bits v, auto shift, uint32_t mask) HWY_ATTR {
    constexpr int kShift = decltype(shift)::value;
    return hn::Or(hn::And(hn::ShiftRight<kShift>(v), splatBits(mask)),
                  hn::ShiftLeft<kShift>(hn::And(v, splatBits(mask))));
  };
  x = swap(x, std::integral_constant<int, 1>(), 0x55555555u);
  x = swap(x, std::integral_constant<int, 2>(), 0x33333333u);
  x = swap(x, std::integral_constant<int, 4>(), 0x0F0F0F0Fu);
  x = swap(x, std::integral_constant<int, 8>(), 0x00FF00FFu);
  return hn::Or(hn::ShiftRight<16>(x), hn::ShiftLeft<16>(x));
}

/// Owen's scrambling of numbers whose digits are reversed: each digit is flipped by those before it (S. Laine
/// and T. Karras, "Stratified Sampling for Stochastic Transparency", 2011, with Burley's constants). In [0,
/// 1).
HWY_INLINE Float scrambled(Bits reversedDigits, Bits seed) {
  Bits x = hn::Add(reversedDigits, seed);
  x = hn::Xor(x, hn::Mul(x, splatBits(0x6c50b47cu)));
  x = hn::Xor(x, hn::Mul(x, splatBits(0xb82f1e52u)));
  x = hn::Xor(x, hn::Mul(x, splatBits(0xc7afe638u)));
  x = hn::Xor(x, hn::Mul(x, splatBits(0x8d22f6e6u)));
  const Bits digits = hn::ShiftRight<8>(reversed(x));
  return hn::Mul(hn::ConvertTo(FloatTag(), hn::BitCast(hn::Rebind<int32_t, FloatTag>(), digits)),
                 splat(0x1p-24f));
}

struct Sample2 {
  Float x, y;
};

/// Sample `index` of a use's two dimensions, for the lanes from i on.
HWY_INLINE Sample2 sample2(const PixelSeeds& seeds, int i, uint32_t index, Dimensions use) {
  const auto number = static_cast<uint32_t>(use);
  const Bits seed =
      hashed(hn::Xor(hn::Load(BitsTag(), seeds.seed + i), splatBits(number * 0x9e3779b9u + 1u)));
  if (seeds.sharing) {
    const uint32_t block = seeds.turns ? turnedBlock(index, number)
                                       : shuffled(index * seeds.sharing, number) & ~(seeds.sharing - 1);
    const Bits at = hn::Xor(splatBits(block), hn::Load(BitsTag(), seeds.first + i)),
               across = hn::Xor(splatBits(reversedSobol(block)), hn::Load(BitsTag(), seeds.second + i));
    return {scrambled(at, seed), scrambled(across, hashed(seed))};
  }
  const uint32_t at = shuffled(index, number);
  return {scrambled(splatBits(at), seed), scrambled(splatBits(reversedSobol(at)), hashed(seed))};
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
