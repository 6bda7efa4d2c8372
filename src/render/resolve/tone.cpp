#include "render/resolve/tone.h"

#include <cmath>

#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/resolve/tone.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// What follows is included once for each instruction set, after Highway's macros.
#include "render/local/fragment.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// IEC 61966-2-1, continued beyond 1.
HWY_INLINE Float decoded(Float c) {
  const Float bent = power(hn::Mul(hn::Add(c, splat(0.055f)), splat(1 / 1.055f)), splat(2.4f));
  return hn::IfThenElse(hn::Le(c, splat(0.04045f)), hn::Mul(c, splat(1 / 12.92f)), bent);
}

HWY_INLINE Float encoded(Float c) {
  const Float bent = hn::MulSub(splat(1.055f), power(c, splat(1 / 2.4f)), splat(0.055f));
  return hn::IfThenElse(hn::Le(c, splat(0.0031308f)), hn::Mul(c, splat(12.92f)), bent);
}

/// (x (a x + b) + e) / (x (c x + d) + f)
HWY_INLINE Float fraction(Float x, float a, float b, float e, float c, float d, float f) {
  const Float above = hn::MulAdd(x, hn::MulAdd(x, splat(a), splat(b)), splat(e));
  return hn::Div(above, hn::MulAdd(x, hn::MulAdd(x, splat(c), splat(d)), splat(f)));
}

HWY_INLINE Float aces(Float x) {
  return fraction(hn::Mul(x, splat(0.6f)), 2.51f, 0.03f, 0, 2.43f, 0.59f, 0.14f);
}

HWY_INLINE Float hable(Float x) {
  // A = 0.15, B = 0.5, C = 0.1, D = 0.2, E = 0.02, F = 0.3
  return hn::Sub(fraction(x, 0.15f, 0.05f, 0.004f, 0.15f, 0.5f, 0.06f), splat(0.02f / 0.3f));
}

HWY_INLINE Float3 reinhard(const Float3& c) {
  const Float luminance =
      hn::MulAdd(c.x, splat(0.2126f), hn::MulAdd(c.y, splat(0.7152f), hn::Mul(c.z, splat(0.0722f))));
  return scaled(c, hn::Div(splat(1), hn::Add(splat(1), luminance)));
}

/// Slope 1 at its start.
HWY_INLINE Float3 shoulder(const Float3& c) {
  constexpr float kStart = 0.6f, kRest = 1 - kStart;
  const Float most = hn::Max(c.x, hn::Max(c.y, c.z)), start = splat(kStart);
  const Float fading = power(splat(2.71828183f), hn::Mul(hn::Sub(start, most), splat(1 / kRest)));
  const Float bent = hn::MulAdd(hn::Sub(splat(1), fading), splat(kRest), start);
  const Float factor = hn::Div(bent, hn::Max(most, start));
  return scaled(c, hn::IfThenElse(hn::Gt(most, start), factor, splat(1)));
}

template <class Curve>
HWY_INLINE Float3 each(const Float3& c, Curve&& curve) {
  return {curve(c.x), curve(c.y), curve(c.z)};
}

HWY_INLINE Float3 bent(Tone tone, const Float3& c) {
  const auto filmic = [](Float x)
                          HWY_ATTR { return hn::Div(hable(hn::Mul(x, splat(2))), hable(splat(11.2f))); };
  switch (tone) {
    case Tone::none: return c;
    case Tone::reinhard: return reinhard(c);
    case Tone::aces: return each(c, [](Float x) HWY_ATTR { return aces(x); });
    case Tone::filmic: return each(c, filmic);
    case Tone::shoulder: return shoulder(c);
  }
  return c;
}

HWY_ATTR void applyTone(const ToneMap& map, ColorRows& rows) {
  // Colours beyond this are no light; NaN becomes 0.
  const Float most = splat(1e6f), zero = hn::Zero(FloatTag());
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    Float3 c = each(load3(rows.value, i), [&](Float v) HWY_ATTR {
      const Float kept = hn::Min(hn::Max(hn::IfThenElseZero(hn::Eq(v, v), v), zero), most);
      return hn::Mul(map.encoded ? decoded(kept) : kept, splat(map.exposure));
    });
    c = each(c, [&](Float v) HWY_ATTR { return hn::Min(v, most); });
    c = bent(map.curve, c);
    if (map.encoded) c = each(c, [](Float v) HWY_ATTR { return encoded(v); });
    store(c.x, rows.value[0] + i), store(c.y, rows.value[1] + i), store(c.z, rows.value[2] + i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gluray::render {

HWY_EXPORT(applyTone);

void ToneMap::apply(ColorRows& rows) const { HWY_DYNAMIC_DISPATCH(applyTone)(*this, rows); }

std::optional<ToneMap> makeToneMap(const scene::Snapshot& snapshot, float factor) {
  const Settings& settings = snapshot.settings;
  const bool acts = settings.exposure != 0 || settings.tone != Tone::none || factor != 1;
  if (settings.look == Look::honest || !acts) return std::nullopt;
  return ToneMap{factor * std::exp2(settings.exposure), settings.tone, !snapshot.encodes};
}

}  // namespace gluray::render
#endif
