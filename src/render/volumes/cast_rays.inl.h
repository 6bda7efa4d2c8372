// Makes colours of the samples of rays. Part of volume_kernels.cpp (compiled once for
// each instruction set).
#if defined(GLURAY_RENDER_CAST_RAYS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_CAST_RAYS_INL_H_
#undef GLURAY_RENDER_CAST_RAYS_INL_H_
#else
#define GLURAY_RENDER_CAST_RAYS_INL_H_
#endif

#include "render/volumes/sample_colors.inl.h"
#include "render/volumes/skipped_samples.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

template <class Samples>
class Caster {
 public:
  /// `samples`: of each channel.
  HWY_ATTR Caster(const VolumeFrame& frame, const Samples* samples)
      : frame_(frame), volume_(*frame.volume), colors_(frame, samples), skipped_(volume_) {}

  /// The finished colours of rays; `shown`: those that show anything.
  HWY_ATTR Colors cast(const Rays& rays, Alive& shown) const {
    const VolumeD d;
    shown = hn::Gt(rays.samples, hn::Zero(d));
    switch (volume_.blend) {
      case scene::VolumeBlend::composite:
        return volume_.use == scene::VolumeChannels::one ? compositeOne(rays, shown) : composite(rays, shown);
      case scene::VolumeBlend::maximum: return extreme<true>(rays, shown);
      case scene::VolumeBlend::minimum: return extreme<false>(rays, shown);
      case scene::VolumeBlend::average: return average(rays, shown);
      case scene::VolumeBlend::additive: return sum(rays, shown);
      case scene::VolumeBlend::isosurface: return isosurfaces(rays, shown);
      default: break;  // LevelCaster's
    }
    return noColors();
  }

 private:
  HWY_ATTR Colors finished(const Colors& c) const {
    const VolumeD d;
    const Floats scale = hn::Set(d, volume_.colorScale), bias = hn::Mul(hn::Set(d, volume_.colorBias), c.a);
    return {hn::MulAdd(c.r, scale, bias), hn::MulAdd(c.g, scale, bias), hn::MulAdd(c.b, scale, bias), c.a};
  }

  /// Puts colours of rays that have `seen` them behind what these have met. Returns the rays that go on.
  HWY_ATTR Alive addBehind(Colors& sum, const Colors& c, Alive seen, Alive alive) const {
    const VolumeD d;
    const Floats share = hn::IfThenElseZero(seen, hn::Sub(hn::Set(d, 1.0f), sum.a));
    sum.r = hn::MulAdd(share, c.r, sum.r), sum.g = hn::MulAdd(share, c.g, sum.g);
    sum.b = hn::MulAdd(share, c.b, sum.b), sum.a = hn::MulAdd(share, c.a, sum.a);
    return hn::And(alive, hn::Le(sum.a, hn::Set(d, volume_.least)));
  }

  HWY_ATTR Colors compositeOf(const Colors& sum, Alive& shown) const {
    if (!frame_.showsInvisible) shown = hn::And(shown, hn::Gt(sum.a, hn::Zero(VolumeD())));
    return finished(sum);
  }
  HWY_ATTR Colors composite(const Rays& rays, Alive& shown) const {
    const VolumeD d;
    const bool skips = skipped_.any();
    Colors sum = noColors();
    Floats sample = hn::Zero(d);
    Leaps leaps(frame_, rays);
    Alive alive = shown;
    while (true) {
      alive = leaps.move(alive, sample);
      if (hn::AllFalse(d, alive)) break;
      const Positions p = rays.at(sample);
      Colors c;
      const Alive seen = colors_.ofMore(rays, p, skips ? skipped_.kept(p, alive) : alive, c);
      if (!hn::AllFalse(d, seen)) {
        if (frame_.arriving) occlude(*frame_.arriving, p, c);
        alive = addBehind(sum, c, seen, alive);
        leaps.stay(seen, sample);
      }
      sample = hn::Add(sample, hn::Set(d, 1.0f));
    }
    return compositeOf(sum, shown);
  }

  /// composite() of a volume of one channel, some samples of each ray at a time: one after the other they
  /// would wait for each other's loads.
  HWY_ATTR Colors compositeOne(const Rays& rays, Alive& shown) const {
    constexpr int kCount = 2;
    const VolumeD d;
    const bool skips = skipped_.any();
    Colors sum = noColors();
    Floats sample = hn::Zero(d);
    Leaps leaps(frame_, rays);
    Alive alive = shown;
    while (true) {
      alive = leaps.move(alive, sample);
      if (hn::AllFalse(d, alive)) break;
      Positions p[kCount];
      Alive counted[kCount], seen[kCount];
      Colors c[kCount];
      for (int i = 0; i < kCount; ++i) {
        const Floats number = hn::Add(sample, hn::Set(d, static_cast<float>(i)));
        p[i] = rays.at(number);
        counted[i] = hn::And(alive, hn::Lt(number, rays.samples));
        if (skips) counted[i] = skipped_.kept(p[i], counted[i]);
      }
      colors_.template ofOne<kCount>(rays, p, counted, c, seen);
      for (int i = 0; i < kCount; ++i) {
        if (frame_.arriving) occlude(*frame_.arriving, p[i], c[i]);
        alive = addBehind(sum, c[i], hn::And(seen[i], alive), alive);
      }
      leaps.stay(seen[kCount - 1], sample);
      sample = hn::Add(sample, hn::Set(d, static_cast<float>(kCount)));
    }
    return compositeOf(sum, shown);
  }

  /// Calls body(sample, position, counted) for every sample of rays that are still `alive`.
  template <class Body>
  HWY_ATTR void eachSample(const Rays& rays, Alive& alive, const Body& body) const {
    const VolumeD d;
    for (Floats sample = hn::Zero(d);; sample = hn::Add(sample, hn::Set(d, 1.0f))) {
      alive = hn::And(alive, hn::Lt(sample, rays.samples));
      if (hn::AllFalse(d, alive)) return;
      const Positions p = rays.at(sample);
      body(sample, p, skipped_.any() ? skipped_.kept(p, alive) : alive);
    }
  }
  /// Calls body(position, counted) for every sample but those in empty space.
  template <class Body>
  HWY_ATTR void eachVisibleSample(const Rays& rays, Alive alive, const Body& body) const {
    const VolumeD d;
    Leaps leaps(frame_, rays);
    for (Floats sample = hn::Zero(d);; sample = hn::Add(sample, hn::Set(d, 1.0f))) {
      alive = leaps.move(alive, sample);
      if (hn::AllFalse(d, alive)) return;
      const Positions p = rays.at(sample);
      body(p, skipped_.any() ? skipped_.kept(p, alive) : alive);
    }
  }

  template <bool most>
  HWY_ATTR Colors extreme(const Rays& rays, Alive shown) const {
    const VolumeD d;
    const float limit =
        most ? -std::numeric_limits<float>::infinity() : std::numeric_limits<float>::infinity();
    Floats found[kMostChannels];
    for (Floats& f : found) f = hn::Set(d, limit);
    Alive alive = shown;
    eachSample(rays, alive, [&](Floats, const Positions& p, Alive counted) HWY_ATTR {
      for (size_t c = 0; c < channels(); ++c) {
        const Floats scalar = colors_.scalarAt(p, c);
        const Alive better = hn::And(counted, most ? hn::Lt(found[c], scalar) : hn::Gt(found[c], scalar));
        found[c] = hn::IfThenElse(better, scalar, found[c]);
      }
    });
    Colors sum = noColors();
    for (size_t c = 0; c < channels(); ++c) {
      // Rays of which no sample counts show the scalar that is the other extreme.
      const Alive none = hn::Eq(found[c], hn::Set(d, limit));
      const Floats scalar = hn::IfThenElse(none, hn::Set(d, most ? 0.0f : 1.0f), found[c]);
      // Lit where the shader's loop leaves the position.
      const Colors color = colors_.colorOf(rays, rays.at(rays.samples), scalar, c);
      const Floats weight = hn::Set(d, volume_.channels[c].weight);
      sum.r = hn::MulAdd(color.r, weight, sum.r), sum.g = hn::MulAdd(color.g, weight, sum.g);
      sum.b = hn::MulAdd(color.b, weight, sum.b), sum.a = hn::MulAdd(color.a, weight, sum.a);
    }
    return finished(sum);
  }

  /// Opacities times scalars of all channels. `counts`: gets how many samples of each are `averaged`; null:
  /// all samples count.
  HWY_ATTR void addProducts(const Positions& p, Alive kept, Floats* totals, Floats* counts) const {
    const VolumeD d;
    for (size_t c = 0; c < channels(); ++c) {
      const Floats scalar = colors_.scalarAt(p, c);
      Alive counted = kept;
      if (counts) {
        const glm::vec2 range = volume_.channels[c].range;
        const Floats value = hn::MulAdd(scalar, hn::Set(d, range.y - range.x), hn::Set(d, range.x));
        counted = hn::And(kept, hn::And(hn::Ge(value, hn::Set(d, volume_.averaged.x)),
                                        hn::Le(value, hn::Set(d, volume_.averaged.y))));
        counts[c] = hn::Add(counts[c], hn::IfThenElseZero(counted, hn::Set(d, 1.0f)));
      }
      const Floats product = hn::Mul(colors_.opacityOf(scalar, c), scalar);
      totals[c] = hn::Add(totals[c], hn::IfThenElseZero(counted, product));
    }
  }

  HWY_ATTR Colors average(const Rays& rays, Alive& shown) const {
    const VolumeD d;
    Floats totals[kMostChannels], counts[kMostChannels];
    for (size_t c = 0; c < kMostChannels; ++c) totals[c] = counts[c] = hn::Zero(d);
    Alive alive = shown;
    eachSample(rays, alive, [&](Floats, const Positions& p, Alive kept) HWY_ATTR {
      addProducts(p, kept, totals, counts);
    });
    // The shader of one channel shows no rays without a sample that counts.
    if (volume_.use == scene::VolumeChannels::one) shown = hn::And(shown, hn::Gt(counts[0], hn::Zero(d)));
    Floats sum = hn::Zero(d);
    for (size_t c = 0; c < channels(); ++c)
      sum = hn::MulAdd(hn::Div(totals[c], hn::Max(counts[c], hn::Set(d, 1.0f))),
                       hn::Set(d, volume_.channels[c].weight), sum);
    return grey(sum);
  }

  HWY_ATTR Colors sum(const Rays& rays, Alive shown) const {
    const VolumeD d;
    Floats totals[kMostChannels];
    for (Floats& total : totals) total = hn::Zero(d);
    Alive alive = shown;
    eachSample(rays, alive, [&](Floats, const Positions& p, Alive kept) HWY_ATTR {
      addProducts(p, kept, totals, nullptr);
    });
    Floats sum = hn::Zero(d);
    for (size_t c = 0; c < channels(); ++c)
      sum = hn::MulAdd(totals[c], hn::Set(d, volume_.channels[c].weight), sum);
    return grey(sum);
  }

  HWY_ATTR Colors grey(Floats value) const {
    const Floats v = clamped(value);
    return finished({v, v, v, hn::Set(VolumeD(), 1.0f)});
  }

  /// Colours of the contours that rays cross, at most one a sample. Contour i lies between intervals i and
  /// i + 1; those of the first sample begin in interval 0 if it does not count.
  HWY_ATTR Colors isosurfaces(const Rays& rays, Alive& shown) const {
    const VolumeD d;
    alignas(64) float lower[kRays], upper[kRays], scalars[kRays], crossed[kRays];
    size_t interval[kRays] = {};
    const auto setInterval = [&](size_t ray, size_t to) {
      const std::vector<float>& contours = volume_.contours;
      interval[ray] = to;
      lower[ray] = to > 0 ? contours[to - 1] : -kFarScalar;
      upper[ray] = to < contours.size() ? contours[to] : kFarScalar;
    };
    for (size_t i = 0; i < kRays; ++i) setInterval(i, 0);
    Colors sum = noColors();
    Alive alive = shown;
    eachSample(rays, alive, [&](Floats sample, const Positions& p, Alive counted) HWY_ATTR {
      const Floats scalar = colors_.scalarAt(p, 0);
      const Alive first = hn::And(counted, hn::Eq(sample, hn::Zero(d)));
      const Alive below = hn::And(counted, hn::Lt(scalar, hn::Load(d, lower))),
                  above = hn::And(counted, hn::Gt(scalar, hn::Load(d, upper)));
      const Alive moved = hn::Or(below, above);
      if (hn::AllFalse(d, moved)) return;
      hn::Store(scalar, d, scalars);
      hn::Store(hn::IfThenElse(above, hn::Load(d, upper), hn::Load(d, lower)), d, crossed);
      alignas(64) float moves[kRays];
      hn::Store(hn::IfThenElseZero(moved, hn::IfThenElse(above, hn::Set(d, 1.0f), hn::Set(d, -1.0f))), d,
                moves);
      const bool begins = !hn::AllFalse(d, first);
      for (size_t i = 0; i < kRays; ++i)
        if (begins && moves[i] != 0)
          setInterval(i, intervalOf(scalars[i]));
        else if (moves[i] != 0)
          setInterval(i, moves[i] > 0 ? interval[i] + 1 : interval[i] - 1);
      const Alive seen = hn::AndNot(first, moved);
      if (!hn::AllFalse(d, seen))
        alive = addBehind(sum, colors_.colorOf(rays, p, hn::Load(d, crossed), 0), seen, alive);
    });
    return compositeOf(sum, shown);
  }
  size_t intervalOf(float scalar) const {
    const auto& contours = volume_.contours;
    return static_cast<size_t>(std::upper_bound(contours.begin(), contours.end(), scalar) - contours.begin());
  }

  size_t channels() const { return volume_.channels.size(); }

  static constexpr size_t kMostChannels = 4;
  static constexpr float kFarScalar = std::numeric_limits<float>::infinity();  // no scalar lies beyond

  const VolumeFrame& frame_;
  const scene::Volume& volume_;
  const SampleColors<Samples> colors_;
  const SkippedSamples skipped_;
};

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#endif
