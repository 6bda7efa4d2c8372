// Makes colours of the samples of rays by one map (scene::VolumeLevels). Part of volume_kernels.cpp (compiled
// once for each instruction set).
#if defined(GLURAY_RENDER_CAST_LEVELS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_CAST_LEVELS_INL_H_
#undef GLURAY_RENDER_CAST_LEVELS_INL_H_
#else
#define GLURAY_RENDER_CAST_LEVELS_INL_H_
#endif

#include "render/volumes/sample_colors.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

template <class Samples>
class LevelCaster {
 public:
  HWY_ATTR LevelCaster(const VolumeFrame& frame, const Samples* samples)
      : volume_(*frame.volume),
        levels_(volume_.levels),
        map_(frame.channels.front().color),
        colors_(frame, samples) {}

  /// The colours of rays, not premultiplied; `shown`: those that show anything; `place`: the number of the
  /// sample whose depth they have.
  HWY_ATTR Colors cast(const Rays& rays, Alive& shown, Floats& place) const {
    const VolumeD d;
    shown = hn::Gt(rays.samples, hn::Zero(d));
    place = hn::Zero(d);
    Colors c = colorsOf(rays, shown, place);
    c.a = hn::Mul(c.a, hn::Set(d, levels_.opacity));
    return c;
  }

 private:
  HWY_ATTR Colors colorsOf(const Rays& rays, Alive& shown, Floats& place) const {
    switch (volume_.blend) {
      case scene::VolumeBlend::refinedMaximum: return refined<true>(rays, shown, place);
      case scene::VolumeBlend::refinedMinimum: return refined<false>(rays, shown, place);
      case scene::VolumeBlend::attenuatedMaximum: return attenuated(rays, shown, place);
      case scene::VolumeBlend::over: return over(rays, shown);
      case scene::VolumeBlend::screened: return screened(rays, shown);
      case scene::VolumeBlend::mean: return mean(rays, shown);
      default: return surface(rays, shown, place);
    }
  }

  HWY_ATTR Floats valueAt(const Positions& p) const { return colors_.scalarAt(p, 0); }

  /// Rays among those `alive` whose sample no plane cuts away.
  HWY_ATTR Alive kept(const Positions& p, Alive alive) const {
    const VolumeD d;
    for (const glm::vec4& plane : levels_.planes) {
      const Floats side = hn::Add(dot(p, spread(glm::vec3(plane))), hn::Set(d, plane.w));
      alive = hn::And(alive, hn::Ge(side, hn::Zero(d)));
    }
    return alive;
  }

  /// Calls body(sample, position, counted) for every sample of rays that are still `alive`. Afterwards
  /// `shown` are rays of which a sample counted.
  template <class Body>
  HWY_ATTR void eachSample(const Rays& rays, Alive& shown, Alive& alive, const Body& body) const {
    const VolumeD d;
    Alive counted = hn::AndNot(shown, shown);
    alive = shown;
    for (Floats sample = hn::Zero(d);; sample = hn::Add(sample, hn::Set(d, 1.0f))) {
      alive = hn::And(alive, hn::Lt(sample, rays.samples));
      if (hn::AllFalse(d, alive)) break;
      const Positions p = rays.at(sample);
      const Alive counts = kept(p, alive);
      counted = hn::Or(counted, counts);
      if (!hn::AllFalse(d, counts)) body(sample, p, counts);
    }
    shown = hn::And(shown, counted);
  }

  /// 0 .. 1 between the limits, before the power.
  HWY_ATTR Floats levelOf(Floats value) const {
    const VolumeD d;
    const glm::vec2& ends = levels_.limits;
    return hn::Div(hn::Sub(value, hn::Set(d, ends.x)), hn::Set(d, ends.y - ends.x));
  }
  HWY_ATTR Colors mapped(Floats value) const {
    const VolumeD d;
    const glm::vec2& ends = levels_.limits;
    const Floats inside =
        hn::Min(hn::Max(value, hn::Set(d, std::min(ends.x, ends.y))), hn::Set(d, std::max(ends.x, ends.y)));
    Floats level = levelOf(inside);
    if (levels_.gamma != 1) level = power(level, levels_.gamma);
    // The map's first and last entries lie at 0 and 1.
    const float entries = map_.count;
    level = hn::MulAdd(level, hn::Set(d, (entries - 1) / entries), hn::Set(d, 0.5f / entries));
    return lookUp(map_, level);
  }

  /// The number of the sample that is `tenths` tenths of a step behind one.
  static HWY_ATTR Floats behind(Floats sample, int tenths) {
    const VolumeD d;
    return hn::Add(sample, hn::Set(d, static_cast<float>(tenths) * 0.1f));
  }
  static constexpr int kParts = 10;

  template <bool most>
  static HWY_ATTR Alive isBetter(Floats value, Floats found) {
    return most ? hn::Gt(value, found) : hn::Lt(value, found);
  }

  template <bool most>
  HWY_ATTR Colors refined(const Rays& rays, Alive& shown, Floats& place) const {
    const VolumeD d;
    const Floats none = hn::Set(d, -1.0f), limit = hn::Set(d, most ? levels_.limits.y : levels_.limits.x);
    Floats found = hn::Set(d, most ? levels_.leastMaximum : levels_.mostMinimum), at = none;
    Alive alive;
    eachSample(rays, shown, alive, [&](Floats sample, const Positions& p, Alive counts) HWY_ATTR {
      const Floats value = valueAt(p);
      const Alive better = hn::And(counts, isBetter<most>(value, found));
      found = hn::IfThenElse(better, value, found), at = hn::IfThenElse(better, sample, at);
      alive = hn::AndNot(hn::And(better, most ? hn::Ge(found, limit) : hn::Le(found, limit)), alive);
    });
    shown = hn::And(shown, hn::Gt(at, none));
    const Floats start = hn::Sub(at, hn::Set(d, 0.5f));
    place = start;
    for (int i = 0; i < kParts; ++i) {
      const Floats sample = behind(start, i), value = valueAt(rays.at(sample));
      const Alive better = isBetter<most>(value, found);
      found = hn::IfThenElse(better, value, found), place = hn::IfThenElse(better, sample, place);
    }
    return mapped(found);
  }

  HWY_ATTR Colors attenuated(const Rays& rays, Alive& shown, Floats& place) const {
    const VolumeD d;
    const Floats none = hn::Set(d, -1.0f);
    Floats found = hn::Set(d, levels_.leastMaximum), sum = hn::Zero(d);
    place = none;
    Alive alive;
    eachSample(rays, shown, alive, [&](Floats sample, const Positions& p, Alive counts) HWY_ATTR {
      const Floats value = valueAt(p);
      const Floats more = hn::Mul(clamped(levelOf(value)), hn::Set(d, levels_.attenuationStep));
      sum = hn::IfThenElse(counts, hn::Add(sum, more), sum);
      const Floats scale =
          hn::Exp(d, hn::Mul(hn::Sub(hn::Set(d, 1.0f), sum), hn::Set(d, levels_.attenuation)));
      const Alive ends = hn::And(counts, hn::Gt(found, hn::Mul(scale, hn::Set(d, levels_.limits.y))));
      const Floats scaledValue = hn::Mul(value, scale);
      const Alive better = hn::AndNot(ends, hn::And(counts, hn::Gt(scaledValue, found)));
      found = hn::IfThenElse(better, scaledValue, found), place = hn::IfThenElse(better, sample, place);
      alive = hn::AndNot(ends, alive);
    });
    shown = hn::And(shown, hn::Gt(place, none));
    return mapped(found);
  }

  HWY_ATTR Colors over(const Rays& rays, Alive& shown) const {
    const VolumeD d;
    const Floats one = hn::Set(d, 1.0f);
    Colors sum = noColors();
    Alive alive;
    eachSample(rays, shown, alive, [&](Floats, const Positions& p, Alive counts) HWY_ATTR {
      const Colors c = mapped(valueAt(p));
      const Floats share = hn::Mul(c.a, hn::Sub(one, sum.a));
      const Floats opacity = hn::Max(hn::Add(sum.a, share), hn::Set(d, 0.001f));
      const Floats front = hn::Div(sum.a, opacity), back = hn::Div(share, opacity);
      const auto mix = [&](Floats a, Floats b) HWY_ATTR {
        return hn::IfThenElse(counts, hn::MulAdd(a, front, hn::Mul(b, back)), a);
      };
      sum.r = mix(sum.r, c.r), sum.g = mix(sum.g, c.g), sum.b = mix(sum.b, c.b);
      sum.a = hn::IfThenElse(counts, opacity, sum.a);
      alive = hn::AndNot(hn::And(counts, hn::Gt(opacity, hn::Set(d, 0.99f))), alive);
    });
    return sum;
  }

  HWY_ATTR Colors screened(const Rays& rays, Alive& shown) const {
    const VolumeD d;
    const Floats one = hn::Set(d, 1.0f);
    Colors left{one, one, one, one};
    Alive alive;
    eachSample(rays, shown, alive, [&](Floats, const Positions& p, Alive counts) HWY_ATTR {
      const Colors c = mapped(valueAt(p));
      const auto less = [&](Floats a, Floats b)
                            HWY_ATTR { return hn::IfThenElse(counts, hn::Mul(a, hn::Sub(one, b)), a); };
      left = {less(left.r, c.r), less(left.g, c.g), less(left.b, c.b), less(left.a, c.a)};
    });
    return {hn::Sub(one, left.r), hn::Sub(one, left.g), hn::Sub(one, left.b), hn::Sub(one, left.a)};
  }

  HWY_ATTR Colors mean(const Rays& rays, Alive& shown) const {
    const VolumeD d;
    Floats count = hn::Zero(d), all = hn::Zero(d);
    Alive alive;
    eachSample(rays, shown, alive, [&](Floats, const Positions& p, Alive counts) HWY_ATTR {
      count = hn::Add(count, hn::IfThenElseZero(counts, hn::Set(d, 1.0f)));
      const Floats change = hn::Div(hn::Sub(valueAt(p), all), hn::Max(count, hn::Set(d, 1.0f)));
      all = hn::Add(all, hn::IfThenElseZero(counts, change));
    });
    return mapped(all);
  }

  HWY_ATTR Colors surface(const Rays& rays, Alive& shown, Floats& place) const {
    constexpr float kBelow = 0.2f;  // how far below the threshold the search begins
    const VolumeD d;
    const Floats threshold = hn::Set(d, levels_.threshold), near = hn::Set(d, levels_.threshold - kBelow);
    const Floats none = hn::Set(d, -2.0f);
    Floats found = hn::Zero(d);
    place = none;
    Alive alive;
    eachSample(rays, shown, alive, [&](Floats sample, const Positions& p, Alive counts) HWY_ATTR {
      Alive waiting = hn::And(counts, hn::Gt(valueAt(p), near));
      const Floats start = hn::Sub(sample, hn::Set(d, 1.0f));
      for (int i = 0; i < kParts && !hn::AllFalse(d, waiting); ++i) {
        const Floats at = behind(start, i), value = valueAt(rays.at(at));
        const Alive hit = hn::And(waiting, hn::Gt(value, threshold));
        found = hn::IfThenElse(hit, value, found), place = hn::IfThenElse(hit, at, place);
        waiting = hn::AndNot(hit, waiting), alive = hn::AndNot(hit, alive);
      }
    });
    shown = hn::And(shown, hn::Gt(place, none));
    return mapped(lit(rays, rays.at(place), found));
  }

  /// The greatest of a value and those around it, lit by a light at the viewer with a highlight.
  HWY_ATTR Floats lit(const Rays& rays, const Positions& p, Floats value) const {
    constexpr float kAmbient = 0.2f, kShininess = 40;
    const VolumeD d;
    const auto difference = [&](Floats x, Floats y, Floats z) HWY_ATTR {
      const Floats before = valueAt({hn::Sub(p.x, x), hn::Sub(p.y, y), hn::Sub(p.z, z)}),
                   after = valueAt({hn::Add(p.x, x), hn::Add(p.y, y), hn::Add(p.z, z)});
      value = hn::Max(value, hn::Max(before, after));
      return hn::Sub(before, after);
    };
    const Floats zero = hn::Zero(d);
    const auto step = [&](int axis) HWY_ATTR { return hn::Set(d, volume_.cellStep[axis]); };
    const Floats x = difference(step(0), zero, zero), y = difference(zero, step(1), zero),
                 z = difference(zero, zero, step(2));
    const Floats cosine = hn::Min(hn::Abs(dot(normalized({x, y, z}), rays.towardsViewer)), hn::Set(d, 1.0f));
    return hn::MulAdd(value, hn::Add(cosine, hn::Set(d, kAmbient)), power(cosine, kShininess));
  }

  const scene::Volume& volume_;
  const scene::VolumeLevels& levels_;
  const VolumeLookup& map_;
  const SampleColors<Samples> colors_;
};

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#endif
