// Colours of a volume's samples: transfer functions, gradients and light. Compiled once for each instruction
// set.
#if defined(GLURAY_RENDER_SAMPLE_COLORS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_SAMPLE_COLORS_INL_H_
#undef GLURAY_RENDER_SAMPLE_COLORS_INL_H_
#else
#define GLURAY_RENDER_SAMPLE_COLORS_INL_H_
#endif

#include "render/volumes/leaps.inl.h"
#include "render/volumes/sample_labels.inl.h"
#include "render/volumes/sample_lighting.inl.h"
#include "render/volumes/sample_scalars.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

template <class Samples>
class SampleColors : private SampleScalars<Samples> {
  using Scalars = SampleScalars<Samples>;
  using Sample = typename Scalars::Sample;
  using Scalars::differencesAt, Scalars::sampleAt, Scalars::volume_;

 public:
  using Scalars::scalarAt;

  /// `samples`: of each channel.
  HWY_ATTR SampleColors(const VolumeFrame& frame, const Samples* samples)
      : Scalars(frame, samples),
        table_(frame.table),
        labels_(volume_.labels),
        lighting_(volume_.shading, frame.arriving) {
    opacity_ = scene::opacityChannelOf(volume_.use);
    const auto orNull = [](const VolumeLookup& table) { return table.entries.empty() ? nullptr : &table; };
    for (size_t c = 0; c < frame.channels.size(); ++c) {
      const ChannelLookups& from = frame.channels[c];
      channels_[c] = {&from.color,
                      orNull(from.opacity),
                      orNull(from.gradient),
                      {lighting_.materialOf(volume_.channels[c].material), volume_.channels[c].material}};
    }
  }

  HWY_ATTR Floats opacityOf(Floats scalar, size_t channel) const {
    const Channel& c = channels_[channel];
    return lookUp(c.opacity ? *c.opacity : *c.color, scalar).a;
  }

  /// The colours of samples at `p` of a volume of one channel, premultiplied. Returns the rays among those
  /// `alive` whose sample counts.
  HWY_INLINE HWY_ATTR Alive ofOne(const Rays& rays, const Positions& p, Alive alive, Colors& c) const {
    return ofChannel(rays, p, alive, 0, c, [](const Colors& found) HWY_ATTR { return premultiplied(found); });
  }
  /// Likewise, of samples at `count` positions of each ray.
  template <int count>
  HWY_INLINE HWY_ATTR void ofOne(const Rays& rays, const Positions* p, const Alive* alive, Colors* c,
                                 Alive* seen) const {
    Sample samples[count];
    Floats scalars[count];
    this->template samplesAt<count>(p, alive, 0, hasGradients(0), samples, scalars);
    looksOf<count>(scalars, 0, c);
    for (int i = 0; i < count; ++i) {
      seen[i] = hn::And(alive[i], hn::Gt(c[i].a, hn::Zero(VolumeD())));
      if (hasGradients(0) && !hn::AllFalse(VolumeD(), seen[i]))
        light(rays, p[i], {differencesAt(p[i], seen[i], samples[i], 0), 0}, 0, c[i]);
      c[i] = premultiplied(c[i]);
    }
  }
  /// Likewise, of other volumes.
  HWY_ATTR Alive ofMore(const Rays& rays, const Positions& p, Alive alive, Colors& c) const {
    switch (volume_.use) {
      case scene::VolumeChannels::independent: return mixed(rays, p, alive, c);
      case scene::VolumeChannels::table: return ofTable(rays, p, alive, c);
      case scene::VolumeChannels::labels: return ofLabels(rays, p, alive, c);
      default: return ofSeveral(rays, p, alive, c);
    }
  }

  /// The colour that a scalar of a channel has at `p`, premultiplied.
  HWY_ATTR Colors colorOf(const Rays& rays, const Positions& p, Floats scalar, size_t channel) const {
    Colors c = lookOf(scalar, channel);
    if (hasGradients(channel)) light(rays, p, {differencesAt(p, channel), channel}, channel, c);
    return premultiplied(c);
  }

 private:
  static HWY_ATTR Colors premultiplied(const Colors& c) {
    const Floats a = clamped(c.a);
    return {hn::Mul(clamped(c.r), a), hn::Mul(clamped(c.g), a), hn::Mul(clamped(c.b), a), a};
  }
  static HWY_ATTR Colors limited(const Colors& c) {
    return {clamped(c.r), clamped(c.g), clamped(c.b), clamped(c.a)};
  }

  /// Unlit colour and opacity.
  HWY_INLINE HWY_ATTR Colors lookOf(Floats scalar, size_t channel) const {
    const Channel& c = channels_[channel];
    Colors colors = lookUp(*c.color, scalar);
    if (c.opacity) colors.a = lookUp(*c.opacity, scalar).a;
    return colors;
  }

  template <int count>
  HWY_INLINE HWY_ATTR void looksOf(const Floats* scalars, size_t channel, Colors* colors) const {
    const Channel& c = channels_[channel];
    lookUp<count>(*c.color, scalars, colors);
    if (!c.opacity) return;
    Colors opacities[count];
    lookUp<count>(*c.opacity, scalars, opacities);
    for (int i = 0; i < count; ++i) colors[i].a = opacities[i].a;
  }

  bool weighs(size_t channel) const { return channels_[channel].gradient != nullptr; }
  /// Whether samples need differences of the channel's scalars.
  bool hasGradients(size_t channel) const { return volume_.shading.enabled() || weighs(channel); }

  /// What a gradient's opacity function makes of its length; of independent channels, all of them and their
  /// weights.
  HWY_ATTR Floats weightOf(Floats strength, size_t channel) const {
    const VolumeD d;
    if (volume_.use != scene::VolumeChannels::independent)
      return lookUp(*channels_[channel].gradient, strength).a;
    Floats all = hn::Set(d, 1.0f);
    for (size_t c = 0; c < volume_.channels.size(); ++c)
      all = hn::Mul(
          all, hn::Mul(lookUp(*channels_[c].gradient, strength).a, hn::Set(d, volume_.channels[c].weight)));
    return all;
  }

  struct Differences {
    Positions scalars;  // across two cell steps
    size_t channel;     // whose scalars they are
  };
  /// The length of a gradient, 0 .. 1, and the gradient in data space.
  HWY_ATTR Floats strengthOf(const Differences& differences, Positions& gradient) const {
    const VolumeD d;
    const glm::vec2& ends = volume_.channels[differences.channel].range;
    const float range = ends.y - ends.x;
    const float average = (volume_.cellSpacing.x + volume_.cellSpacing.y + volume_.cellSpacing.z) / 3;
    gradient = scaled(differences.scalars, glm::vec3(range) / (volume_.cellSpacing * 2.0f / average));
    const Floats length = hn::Sqrt(dot(gradient, gradient));
    return clamped(hn::Div(length, hn::Set(d, 0.25f * (range != 0 ? range : 1))));
  }

  /// Lights colours with the look of a channel, and applies its gradient opacity.
  HWY_ATTR void light(const Rays& rays, const Positions& p, const Differences& differences, size_t channel,
                      Colors& c) const {
    Positions gradient;
    if (weighs(channel))
      c.a = hn::Mul(c.a, weightOf(strengthOf(differences, gradient), channel));
    else
      gradient = scaled(differences.scalars, 1.0f / volume_.cellSpacing);
    lighting_.shade(channels_[channel].material, p, rays.towardsViewer, gradient, c);
  }

  /// finish(colour and opacity) of a channel with transfer functions of its own.
  template <class Finish>
  HWY_INLINE HWY_ATTR Alive ofChannel(const Rays& rays, const Positions& p, Alive alive, size_t channel,
                                      Colors& c, const Finish& finish) const {
    const VolumeD d;
    Sample sample;
    sampleAt(p, alive, channel, hasGradients(channel), sample);
    c = lookOf(sample.scalar, channel);
    const Alive seen = hn::And(alive, hn::Gt(c.a, hn::Zero(d)));
    if (hn::AllFalse(d, seen)) return seen;
    if (hasGradients(channel)) light(rays, p, {differencesAt(p, seen, sample, channel), channel}, channel, c);
    c = finish(c);
    return seen;
  }

  /// Colours and opacities by scalar and gradient. They are not limited to 0 .. 1.
  HWY_ATTR Alive ofTable(const Rays& rays, const Positions& p, Alive alive, Colors& c) const {
    const VolumeD d;
    Sample sample;
    sampleAt(p, alive, 0, true, sample);
    Positions gradient;
    const Floats strength = strengthOf({differencesAt(p, alive, sample, 0), 0}, gradient);
    c = lookUp(table_, sample.scalar, strength);
    const Alive seen = hn::And(alive, hn::Gt(c.a, hn::Zero(d)));
    if (hn::AllFalse(d, seen)) return seen;
    lighting_.shade(channels_[0].material, p, rays.towardsViewer, gradient, c);
    c = byOpacity(c);
    return seen;
  }

  /// Colours and opacities of samples with and without labels. Those of labels are not limited to 0 .. 1, and
  /// have no gradient opacity.
  HWY_ATTR Alive ofLabels(const Rays& rays, const Positions& p, Alive alive, Colors& c) const {
    const VolumeD d;
    Sample sample;
    sampleAt(p, alive, 0, hasGradients(0), sample);
    const Floats row = labels_.rowsAt(p), share = hn::Set(d, volume_.labels.share);
    const Alive labelled = hn::And(alive, hn::Ne(row, hn::Zero(d)));
    c = lookOf(sample.scalar, 0);
    Colors label = lookUp(table_, sample.scalar, row);
    const Alive visible = hn::And(alive, hn::Gt(c.a, hn::Zero(d))),
                labelVisible = hn::And(labelled, hn::Gt(label.a, hn::Zero(d)));
    if (hn::AllFalse(d, hn::Or(visible, labelVisible))) return labelVisible;
    if (hasGradients(0)) {
      const Differences differences{differencesAt(p, alive, sample, 0), 0};
      light(rays, p, differences, 0, c);
      Positions gradient = scaled(differences.scalars, 1.0f / volume_.cellSpacing);
      if (weighs(0)) strengthOf(differences, gradient);
      Colors lit = label;
      lighting_.shade(channels_[0].material, p, rays.towardsViewer, gradient, lit);
      label = chosen(labelVisible, lit, label);
    }
    c = chosen(visible, limited(c), noColors());
    c = chosen(labelled, mixedColors(c, label, share), c);
    const Alive seen = hn::And(alive, hn::Gt(c.a, hn::Zero(d)));
    c = byOpacity(c);
    return seen;
  }

  /// Channels with transfer functions of their own, mixed by weights.
  HWY_ATTR Alive mixed(const Rays& rays, const Positions& p, Alive alive, Colors& sum) const {
    const VolumeD d;
    const size_t channels = volume_.channels.size();
    Colors colors[4];
    Floats total = hn::Zero(d);
    for (size_t i = 0; i < channels; ++i) {
      const Alive seen = ofChannel(rays, p, alive, i, colors[i],
                                   [](const Colors& found) HWY_ATTR { return limited(found); });
      colors[i].a = hn::IfThenElseZero(seen, colors[i].a);
      total = hn::MulAdd(colors[i].a, hn::Set(d, volume_.channels[i].weight), total);
    }
    const Alive seen = hn::And(alive, hn::Gt(total, hn::Zero(d)));
    sum = noColors();
    for (size_t i = 0; i < channels; ++i) {
      if (volume_.channels[i].weight <= 0) continue;
      const Colors& c = colors[i];
      const Floats share = hn::Mul(c.a, hn::Set(d, volume_.channels[i].weight));
      sum.r = hn::MulAdd(c.r, share, sum.r), sum.g = hn::MulAdd(c.g, share, sum.g);
      sum.b = hn::MulAdd(c.b, share, sum.b);
      sum.a = hn::Add(sum.a, hn::IfThenElseZero(seen, hn::Div(hn::Mul(c.a, c.a), total)));
    }
    return seen;
  }

  /// Colours and opacities of different channels.
  HWY_ATTR Alive ofSeveral(const Rays& rays, const Positions& p, Alive alive, Colors& c) const {
    const VolumeD d;
    const Floats opacity = opacityOf(scalarAt(p, opacity_), opacity_);
    const Alive seen = hn::And(alive, hn::Gt(opacity, hn::Zero(d)));
    if (hn::AllFalse(d, seen)) return seen;
    if (volume_.use == scene::VolumeChannels::colors)
      c = {scalarAt(p, 0), scalarAt(p, 1), scalarAt(p, 2), opacity};
    else
      c = lookUp(*channels_[0].color, scalarAt(p, 0)), c.a = opacity;
    const size_t gradient = volume_.gradientChannel;
    if (hasGradients(0)) light(rays, p, {differencesAt(p, gradient), gradient}, 0, c);
    c = premultiplied(c);
    return seen;
  }

  struct Channel {
    const VolumeLookup *color, *opacity, *gradient;  // null: color has it, and none
    Lighting::Materials material;
  };

  const VolumeLookup2D& table_;
  Channel channels_[4] = {};
  const SampleLabels labels_;
  const Lighting lighting_;
  size_t opacity_ = 0;
};

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#endif
