// Makes colours of the samples of rays. Part of volume_kernels.cpp (compiled once for
// each instruction set).
#if defined(GLURAY_RENDER_CAST_RAYS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_CAST_RAYS_INL_H_
#undef GLURAY_RENDER_CAST_RAYS_INL_H_
#else
#define GLURAY_RENDER_CAST_RAYS_INL_H_
#endif

#include "render/volumes/leaps.inl.h"
#include "render/volumes/transfer_lookups.inl.h"
#include "render/volumes/voxel_samples.inl.h"

#include <hwy/contrib/math/math-inl.h>

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

template <class Samples>
class Caster {
 public:
  HWY_ATTR Caster(const VolumeFrame& frame, const Samples& samples)
      : frame_(frame), volume_(*frame.volume), samples_(samples) {
    const VolumeD d;
    const float divisor = scene::divisorOf(volume_.grid->type);
    scale_ = hn::Set(d, volume_.scale / divisor), bias_ = hn::Set(d, volume_.bias);
    const glm::vec3 beyond = volume_.cellStep * glm::vec3(volume_.grid->size) - 1.0f;
    stepsAreVoxels_ = hasGradients() &&
                      std::min({volume_.grid->size.x, volume_.grid->size.y, volume_.grid->size.z}) >= 4 &&
                      glm::all(glm::lessThan(glm::abs(beyond), glm::vec3(0.01f)));
  }

  /// The finished colours of rays; `shown`: those that show anything.
  HWY_ATTR Colors cast(const Rays& rays, Alive& shown) const {
    const VolumeD d;
    shown = hn::Gt(rays.samples, hn::Zero(d));
    switch (volume_.blend) {
      case scene::VolumeBlend::composite: return composite(rays, shown);
      case scene::VolumeBlend::maximum: return extreme<true>(rays, shown);
      case scene::VolumeBlend::minimum: return extreme<false>(rays, shown);
      case scene::VolumeBlend::average: return average(rays, shown);
      case scene::VolumeBlend::additive: return sum(rays, shown);
    }
    return noColors();
  }

 private:
  HWY_ATTR Floats scalarAt(const Positions& p) const { return hn::MulAdd(samples_.at(p), scale_, bias_); }

  /// Unlit colour and opacity.
  HWY_ATTR Colors lookOf(Floats scalar) const {
    Colors colors = lookUp(frame_.color, scalar);
    if (!frame_.opacity.entries.empty()) colors.a = lookUp(frame_.opacity, scalar).a;
    return colors;
  }
  HWY_ATTR Floats opacityOf(Floats scalar) const {
    return (frame_.opacity.entries.empty() ? lookUp(frame_.color, scalar) : lookUp(frame_.opacity, scalar)).a;
  }

  static HWY_ATTR Floats clamped(Floats v) {
    const VolumeD d;
    return hn::Min(hn::Max(v, hn::Zero(d)), hn::Set(d, 1.0f));
  }
  static HWY_ATTR Floats dot(const Positions& a, const Positions& b) {
    return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
  }

  /// A scalar and, for rays that are `known`, the differences of scalars around it.
  struct Sample {
    Floats scalar;
    Positions differences;
    Alive known;
  };
  HWY_ATTR Sample sampleAt(const Positions& p, Alive alive) const {
    const VolumeD d;
    const Floats none = hn::Zero(d);
    typename Samples::Around around{none, {none, none, none}};
    Alive known = hn::Lt(none, none);
    if constexpr (Samples::kHasWindows)
      if (stepsAreVoxels_) known = samples_.around(p, volume_.cellStep, around);
    Floats scalar = hn::MulAdd(around.here, scale_, bias_);
    if (!hn::AllFalse(d, hn::AndNot(known, alive))) scalar = hn::IfThenElse(known, scalar, scalarAt(p));
    return {scalar, scaled(around.differences, scale_), known};
  }
  HWY_ATTR Positions differencesAt(const Positions& p, Alive seen, const Sample& sample) const {
    const VolumeD d;
    if (hn::AllFalse(d, hn::AndNot(sample.known, seen))) return sample.differences;
    const Positions other = differencesAt(p);
    return {hn::IfThenElse(sample.known, sample.differences.x, other.x),
            hn::IfThenElse(sample.known, sample.differences.y, other.y),
            hn::IfThenElse(sample.known, sample.differences.z, other.z)};
  }

  /// Differences of scalars around a sample.
  HWY_ATTR Positions differencesAt(const Positions& p) const {
    const VolumeD d;
    const Floats x = hn::Set(d, volume_.cellStep.x), y = hn::Set(d, volume_.cellStep.y),
                 z = hn::Set(d, volume_.cellStep.z);
    return {hn::Sub(scalarAt({hn::Add(p.x, x), p.y, p.z}), scalarAt({hn::Sub(p.x, x), p.y, p.z})),
            hn::Sub(scalarAt({p.x, hn::Add(p.y, y), p.z}), scalarAt({p.x, hn::Sub(p.y, y), p.z})),
            hn::Sub(scalarAt({p.x, p.y, hn::Add(p.z, z)}), scalarAt({p.x, p.y, hn::Sub(p.z, z)}))};
  }

  static HWY_ATTR Positions scaled(const Positions& v, Floats by) {
    return {hn::Mul(v.x, by), hn::Mul(v.y, by), hn::Mul(v.z, by)};
  }
  static HWY_ATTR Positions scaled(const Positions& v, const glm::vec3& by) {
    const VolumeD d;
    return {hn::Mul(v.x, hn::Set(d, by.x)), hn::Mul(v.y, hn::Set(d, by.y)), hn::Mul(v.z, hn::Set(d, by.z))};
  }

  /// Whether samples need differences of scalars.
  bool hasGradients() const { return volume_.light.enabled || !frame_.gradient.entries.empty(); }

  /// Lights the colours and applies the gradient's opacity. `differences`: of scalars, across two cell steps.
  HWY_ATTR void light(const Rays& rays, const Positions& differences, Colors& c) const {
    const VolumeD d;
    const bool weighs = !frame_.gradient.entries.empty();
    Positions normal = differences;
    if (weighs) {
      const float range = volume_.range.y - volume_.range.x;
      const float average = (volume_.cellSpacing.x + volume_.cellSpacing.y + volume_.cellSpacing.z) / 3;
      normal = scaled(normal, glm::vec3(range) / (volume_.cellSpacing * 2.0f / average));
      const Floats length = hn::Sqrt(dot(normal, normal));
      const Floats strength = clamped(hn::Div(length, hn::Set(d, 0.25f * (range != 0 ? range : 1))));
      c.a = hn::Mul(c.a, lookUp(frame_.gradient, strength).a);
    } else {
      normal = scaled(normal, 1.0f / volume_.cellSpacing);
    }
    if (volume_.light.enabled) shade(rays.towardsViewer, normal, c);
  }

  HWY_ATTR void shade(const Positions& towards, const Positions& gradient, Colors& c) const {
    const VolumeD d;
    const scene::VolumeLight& light = volume_.light;
    const Floats one = hn::Set(d, 1.0f), zero = hn::Zero(d);
    const Floats length = hn::Sqrt(dot(gradient, gradient));
    const Floats inverse = hn::IfThenElseZero(hn::Gt(length, zero), hn::Div(one, length));
    // The light stands at the viewer.
    Floats cosine = hn::Mul(hn::Neg(dot(gradient, towards)), inverse);
    const Floats reflected = hn::MulSub(hn::Add(cosine, cosine), cosine, one);
    if (light.twoSided) cosine = hn::Abs(cosine);
    const Alive lit = hn::Gt(cosine, zero);
    const Floats shine = hn::IfThenElseZero(
        lit, hn::IfThenElse(hn::Gt(reflected, zero),
                            hn::Exp(d, hn::Mul(hn::Set(d, light.shininess),
                                               hn::Log(d, hn::Max(reflected, hn::Set(d, 1e-30f))))),
                            hn::Set(d, light.shininess == 0 ? 1.0f : 0.0f)));
    const Floats diffuse = hn::IfThenElseZero(lit, cosine);
    const auto channel = [&](Floats color, int i) HWY_ATTR {
      const Floats share = hn::MulAdd(diffuse, hn::Set(d, light.diffuse[i]), hn::Set(d, light.ambient[i]));
      return hn::MulAdd(color, share, hn::Mul(shine, hn::Set(d, light.specular[i])));
    };
    c.r = channel(c.r, 0), c.g = channel(c.g, 1), c.b = channel(c.b, 2);
  }

  HWY_ATTR Colors finished(const Colors& c) const {
    const VolumeD d;
    const Floats scale = hn::Set(d, volume_.colorScale), bias = hn::Mul(hn::Set(d, volume_.colorBias), c.a);
    return {hn::MulAdd(c.r, scale, bias), hn::MulAdd(c.g, scale, bias), hn::MulAdd(c.b, scale, bias), c.a};
  }

  HWY_ATTR Colors composite(const Rays& rays, Alive& shown) const {
    const VolumeD d;
    const Floats one = hn::Set(d, 1.0f), most = hn::Set(d, volume_.least);
    Colors sum = noColors();
    Floats sample = hn::Zero(d);
    Leaps leaps(frame_, rays);
    Alive alive = shown;
    while (true) {
      alive = frame_.empty ? leaps.move(alive, sample) : hn::And(alive, hn::Lt(sample, rays.samples));
      if (hn::AllFalse(d, alive)) break;
      const Positions p = rays.at(sample);
      const Sample at = sampleAt(p, alive);
      Colors c = lookOf(at.scalar);
      const Alive seen = hn::And(alive, hn::Gt(c.a, hn::Zero(d)));
      if (!hn::AllFalse(d, seen)) {
        if (hasGradients()) light(rays, differencesAt(p, seen, at), c);
        const Floats a = clamped(c.a), share = hn::IfThenElseZero(seen, hn::Mul(hn::Sub(one, sum.a), a));
        sum.r = hn::MulAdd(share, clamped(c.r), sum.r), sum.g = hn::MulAdd(share, clamped(c.g), sum.g);
        sum.b = hn::MulAdd(share, clamped(c.b), sum.b), sum.a = hn::Add(sum.a, share);
        alive = hn::And(alive, hn::Le(sum.a, most));
        leaps.stay(seen, sample);
      }
      sample = hn::Add(sample, one);
    }
    shown = hn::And(shown, hn::Gt(sum.a, hn::Zero(d)));
    return finished(sum);
  }

  /// Calls body(position, alive) for every sample of the rays.
  template <class Body>
  HWY_ATTR void eachSample(const Rays& rays, Alive alive, const Body& body) const {
    const VolumeD d;
    for (Floats sample = hn::Zero(d);; sample = hn::Add(sample, hn::Set(d, 1.0f))) {
      alive = hn::And(alive, hn::Lt(sample, rays.samples));
      if (hn::AllFalse(d, alive)) return;
      body(rays.at(sample), alive);
    }
  }

  template <bool most>
  HWY_ATTR Colors extreme(const Rays& rays, Alive shown) const {
    const VolumeD d;
    const float limit = std::numeric_limits<float>::infinity();
    Floats found = hn::Set(d, most ? -limit : limit);
    eachSample(rays, shown, [&](const Positions& p, Alive alive) HWY_ATTR {
      const Floats scalar = scalarAt(p);
      const Alive better = hn::And(alive, most ? hn::Lt(found, scalar) : hn::Gt(found, scalar));
      found = hn::IfThenElse(better, scalar, found);
    });
    Colors c = lookOf(hn::IfThenElseZero(shown, found));
    if (hasGradients())  // where the shader's loop leaves the position
      light(rays, differencesAt(rays.at(rays.samples)), c);
    const Floats a = clamped(c.a);
    return finished({hn::Mul(clamped(c.r), a), hn::Mul(clamped(c.g), a), hn::Mul(clamped(c.b), a), a});
  }

  HWY_ATTR Colors average(const Rays& rays, Alive& shown) const {
    const VolumeD d;
    const glm::vec2 range = volume_.range;
    Floats total = hn::Zero(d), count = hn::Zero(d);
    eachSample(rays, shown, [&](const Positions& p, Alive alive) HWY_ATTR {
      const Floats scalar = scalarAt(p);
      const Floats value = hn::MulAdd(scalar, hn::Set(d, range.y - range.x), hn::Set(d, range.x));
      const Alive counted = hn::And(alive, hn::And(hn::Ge(value, hn::Set(d, volume_.averaged.x)),
                                                   hn::Le(value, hn::Set(d, volume_.averaged.y))));
      total = hn::Add(total, hn::IfThenElseZero(counted, hn::Mul(opacityOf(scalar), scalar)));
      count = hn::Add(count, hn::IfThenElseZero(counted, hn::Set(d, 1.0f)));
    });
    shown = hn::And(shown, hn::Gt(count, hn::Zero(d)));
    return grey(hn::Div(total, hn::Max(count, hn::Set(d, 1.0f))));
  }

  HWY_ATTR Colors sum(const Rays& rays, Alive shown) const {
    const VolumeD d;
    Floats total = hn::Zero(d);
    eachSample(rays, shown, [&](const Positions& p, Alive alive) HWY_ATTR {
      const Floats scalar = scalarAt(p);
      total = hn::Add(total, hn::IfThenElseZero(alive, hn::Mul(opacityOf(scalar), scalar)));
    });
    return grey(total);
  }

  HWY_ATTR Colors grey(Floats value) const {
    const Floats v = clamped(value);
    return finished({v, v, v, hn::Set(VolumeD(), 1.0f)});
  }

  const VolumeFrame& frame_;
  const scene::Volume& volume_;
  const Samples& samples_;
  Floats scale_, bias_;
  bool stepsAreVoxels_ = false;  // gradients need samples about a voxel apart
};

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#endif
