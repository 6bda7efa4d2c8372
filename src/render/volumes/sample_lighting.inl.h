// Lights the samples of a volume. Compiled once for each instruction set.
#if defined(GLURAY_RENDER_SAMPLE_LIGHTING_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_SAMPLE_LIGHTING_INL_H_
#undef GLURAY_RENDER_SAMPLE_LIGHTING_INL_H_
#else
#define GLURAY_RENDER_SAMPLE_LIGHTING_INL_H_
#endif

#include "render/volumes/arriving_samples.inl.h"

#include <hwy/contrib/math/math-inl.h>

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

HWY_ATTR inline Floats clamped(Floats v) {
  const VolumeD d;
  return hn::Min(hn::Max(v, hn::Zero(d)), hn::Set(d, 1.0f));
}
HWY_ATTR inline Floats dot(const Positions& a, const Positions& b) {
  return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}
HWY_ATTR inline Positions scaled(const Positions& v, Floats by) {
  return {hn::Mul(v.x, by), hn::Mul(v.y, by), hn::Mul(v.z, by)};
}
HWY_ATTR inline Positions scaled(const Positions& v, const glm::vec3& by) {
  const VolumeD d;
  return {hn::Mul(v.x, hn::Set(d, by.x)), hn::Mul(v.y, hn::Set(d, by.y)), hn::Mul(v.z, hn::Set(d, by.z))};
}
HWY_ATTR inline Positions difference(const Positions& a, const Positions& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_ATTR inline Positions spread(const glm::vec3& v) {
  const VolumeD d;
  return {hn::Set(d, v.x), hn::Set(d, v.y), hn::Set(d, v.z)};
}
/// One over the square root of numbers above 0.
HWY_ATTR inline Floats inverseRoot(Floats v) {
  const VolumeD d;
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR
  const Floats half = hn::Mul(v, hn::Set(d, 0.5f)), guess = hn::ApproximateReciprocalSqrt(v);
  // A step of Newton's method doubles the digits.
  return hn::Mul(guess, hn::NegMulAdd(hn::Mul(half, guess), guess, hn::Set(d, 1.5f)));
#else
  return hn::Div(hn::Set(d, 1.0f), hn::Sqrt(v));
#endif
}
/// A vector of length 1; 0 stays 0, as do lengths whose square is no normal number.
HWY_ATTR inline Positions normalized(const Positions& v) {
  const VolumeD d;
  const Floats square = dot(v, v);
  const Alive any = hn::Ge(square, hn::Set(d, std::numeric_limits<float>::min()));
  return scaled(v, hn::IfThenElseZero(any, inverseRoot(square)));
}
/// A power of a number that is not below 0.
HWY_ATTR inline Floats anyPower(Floats base, float exponent) {
  const VolumeD d;
  return hn::IfThenElse(
      hn::Gt(base, hn::Zero(d)),
      hn::Exp(d, hn::Mul(hn::Set(d, exponent), hn::Log(d, hn::Max(base, hn::Set(d, 1e-30f))))),
      hn::Set(d, exponent == 0 ? 1.0f : 0.0f));
}
/// Likewise, of numbers up to about 1; others count as 0 if they are below 0.
HWY_ATTR inline Floats power(Floats base, float exponent) {
  constexpr float kMostProducts = 128;
  if (!(exponent >= 1 && exponent <= kMostProducts && exponent == std::floor(exponent)))
    return anyPower(base, exponent);
  const VolumeD d;
  Floats square = hn::Max(base, hn::Zero(d)), product = hn::Set(d, 1.0f);
  for (auto bits = static_cast<uint32_t>(exponent); bits; bits >>= 1, square = hn::Mul(square, square))
    if (bits & 1) product = hn::Mul(product, square);
  return product;
}

class Lighting {
 public:
  /// `arriving`: null: all light arrives, and none is added.
  Lighting(const scene::VolumeShading& shading, const SampleIllumination* arriving)
      : shading_(shading), arriving_(arriving) {}

  /// A material as shade() takes it: lit by a light at the viewer, times its colours.
  scene::VolumeMaterial materialOf(const scene::VolumeMaterial& material) const {
    scene::VolumeMaterial lit = material;
    if (arriving_) lit.diffuse *= arriving_->programShare, lit.specular *= arriving_->programShare;
    if (!shading_.isFromViewer()) return lit;
    lit.diffuse *= shading_.lights.front().diffuse, lit.specular *= shading_.lights.front().specular;
    return lit;
  }

  struct Materials {
    scene::VolumeMaterial lit;    // of materialOf()
    scene::VolumeMaterial plain;  // the volume's own
  };
  /// Makes lit colours of unlit ones. `p`: samples in texture space; `gradient`: in data space, of any
  /// length.
  HWY_ATTR void shade(const Materials& materials, const Positions& p, const Positions& towardsViewer,
                      const Positions& gradient, Colors& c) const {
    if (!shading_.enabled()) return;
    const Colors unlit = c;
    if (shading_.isFromViewer())
      shadeFromViewer(materials.lit, dot(normalized(gradient), towardsViewer), c);
    else
      shadeByLights(materials.lit, p, gradient, c);
    if (arriving_) shadeByAdded(materials.plain, p, gradient, unlit, c);
  }

 private:
  /// `facing`: cosine between the gradient and the direction to the viewer, where the light stands.
  HWY_ATTR void shadeFromViewer(const scene::VolumeMaterial& material, Floats facing, Colors& c) const {
    const VolumeD d;
    const Floats zero = hn::Zero(d);
    const bool halfway = shading_.isHalfway();
    Floats cosine = halfway ? facing : hn::Neg(facing);
    Floats highlight = cosine;
    if (!halfway) highlight = hn::MulSub(hn::Add(cosine, cosine), cosine, hn::Set(d, 1.0f));
    if (shading_.twoSided) cosine = hn::Abs(cosine);
    if (halfway) highlight = cosine;
    const Floats diffuse = hn::Max(cosine, zero);
    Floats shine = power(highlight, material.shininess);
    if (!halfway) shine = hn::IfThenElseZero(hn::Gt(cosine, zero), shine);
    const auto channel = [&](Floats color, int i) HWY_ATTR {
      const Floats share =
          hn::MulAdd(diffuse, hn::Set(d, material.diffuse[i]), hn::Set(d, material.ambient[i]));
      return hn::MulAdd(color, share, hn::Mul(shine, hn::Set(d, material.specular[i])));
    };
    c.r = channel(c.r, 0), c.g = channel(c.g, 1), c.b = channel(c.b, 2);
  }

  static HWY_ATTR Positions transformed(const glm::mat3& m, const Positions& v) {
    const VolumeD d;
    const auto row = [&](int i) HWY_ATTR {
      return hn::MulAdd(hn::Set(d, m[0][i]), v.x,
                        hn::MulAdd(hn::Set(d, m[1][i]), v.y, hn::Mul(hn::Set(d, m[2][i]), v.z)));
    };
    return {row(0), row(1), row(2)};
  }

  /// Where a light's rays go at a point of eye space, and how much of them arrives.
  HWY_ATTR Positions raysOf(const scene::VolumeLight& light, const Positions& point, Floats& arrives) const {
    const VolumeD d;
    arrives = hn::Set(d, 1.0f);
    if (!light.positional) return spread(light.direction);
    const Positions along = difference(point, spread(light.position));
    const Floats distance = hn::Sqrt(dot(along, along));
    const Positions direction = normalized(along);
    arrives = hn::Div(arrives, hn::MulAdd(hn::MulAdd(hn::Set(d, light.attenuation.z), distance,
                                                     hn::Set(d, light.attenuation.y)),
                                          distance, hn::Set(d, light.attenuation.x)));
    if (light.coneAngle > 90) return direction;
    const Floats cosine = dot(direction, spread(light.direction));
    const Floats least = hn::Set(d, std::cos(glm::radians(light.coneAngle)));
    arrives = hn::IfThenElseZero(hn::Ge(cosine, least), hn::Mul(arrives, power(cosine, light.exponent)));
    return direction;
  }

  struct Sums {
    Positions diffuse, specular;
  };
  /// `passes`: what of the light reaches the samples; null: all.
  HWY_ATTR void add(const scene::VolumeLight& light, float shininess, const Positions& point,
                    const Positions& normal, const Floats* passes, Sums& sums) const {
    const VolumeD d;
    const Floats zero = hn::Zero(d);
    Floats arrives;
    const Positions rays = raysOf(light, point, arrives);
    if (passes) arrives = hn::Mul(arrives, *passes);
    Floats cosine = dot(normal, rays);
    if (shading_.twoSided) cosine = hn::Abs(cosine);
    const Alive lit = hn::Gt(cosine, zero);
    const Positions view = normalized(point);
    const Positions reflected = normalized(difference(scaled(normal, hn::Add(cosine, cosine)), rays));
    const bool halfway = shading_.isHalfway();
    Floats highlight = halfway ? dot(normal, normalized(difference(rays, view))) : dot(view, reflected);
    if (shading_.twoSided && (halfway || light.positional)) highlight = hn::Abs(highlight);
    Alive shines = hn::Gt(highlight, zero);
    if (!halfway) shines = hn::And(lit, shines);
    const Floats diffuse = hn::IfThenElseZero(lit, hn::Max(hn::Mul(arrives, cosine), zero));
    const Floats specular = hn::IfThenElseZero(shines, hn::Mul(arrives, power(highlight, shininess)));
    const auto addTo = [](Positions& sum, Floats share, const glm::vec3& color) HWY_ATTR {
      const Positions part = scaled({share, share, share}, color);
      sum = {hn::Add(sum.x, part.x), hn::Add(sum.y, part.y), hn::Add(sum.z, part.z)};
    };
    addTo(sums.diffuse, diffuse, light.diffuse), addTo(sums.specular, specular, light.specular);
  }

  static HWY_ATTR Positions placed(const glm::mat4& m, const Positions& p) {
    const VolumeD d;
    const Positions moved = transformed(glm::mat3(m), p);
    return {hn::Add(moved.x, hn::Set(d, m[3].x)), hn::Add(moved.y, hn::Set(d, m[3].y)),
            hn::Add(moved.z, hn::Set(d, m[3].z))};
  }

  /// add(), of a light with this row of SampleIllumination::shadows; -1: none.
  HWY_ATTR void addShadowed(const scene::VolumeLight& light, int row, float shininess, const Positions& point,
                            const Positions& normal, const LatticePlaces& places, Sums& sums) const {
    if (row < 0) return add(light, shininess, point, normal, nullptr, sums);
    const Floats passes = places.valueOf(arriving_->shadows[static_cast<size_t>(row)]);
    add(light, shininess, point, normal, &passes, sums);
  }

  /// Adds the light of the settings to lit colours.
  HWY_ATTR void shadeByAdded(const scene::VolumeMaterial& material, const Positions& p,
                             const Positions& gradient, const Colors& unlit, Colors& c) const {
    const VolumeD d;
    const Positions point = placed(arriving_->eyeFromTexture, p);
    const Positions normal = normalized(transformed(arriving_->eyeFromGradient, gradient));
    const LatticePlaces places(*arriving_, p);
    Sums sums{spread(arriving_->ambient), spread(glm::vec3(0))};
    for (const ShadowedLight& added : arriving_->added)
      addShadowed(added.light, added.row, material.shininess, point, normal, places, sums);
    const auto channel = [&](Floats lit, Floats color, Floats diffuse, Floats specular, int i) HWY_ATTR {
      return hn::MulAdd(hn::Mul(diffuse, hn::Set(d, material.diffuse[i])), color,
                        hn::MulAdd(specular, hn::Set(d, material.specular[i]), lit));
    };
    c.r = channel(c.r, unlit.r, sums.diffuse.x, sums.specular.x, 0);
    c.g = channel(c.g, unlit.g, sums.diffuse.y, sums.specular.y, 1);
    c.b = channel(c.b, unlit.b, sums.diffuse.z, sums.specular.z, 2);
  }

  HWY_ATTR void shadeByLights(const scene::VolumeMaterial& material, const Positions& p,
                              const Positions& gradient, Colors& c) const {
    const VolumeD d;
    const Positions point = placed(shading_.eyeFromTexture, p);
    const Positions normal = normalized(transformed(shading_.eyeFromGradient, gradient));
    Sums sums{spread(glm::vec3(0)), spread(glm::vec3(0))};
    glm::vec3 ambient(0);
    if (arriving_ && !arriving_->shadows.empty()) {
      const LatticePlaces places(*arriving_, p);
      for (size_t i = 0; i < shading_.lights.size(); ++i)
        addShadowed(shading_.lights[i], arriving_->rows[i], material.shininess, point, normal, places, sums);
    } else {
      for (const scene::VolumeLight& light : shading_.lights)
        add(light, material.shininess, point, normal, nullptr, sums);
    }
    for (const scene::VolumeLight& light : shading_.lights) ambient += light.ambient;
    const auto channel = [&](Floats color, Floats diffuse, Floats specular, int i) HWY_ATTR {
      const Floats unlit = hn::Set(d, material.ambient[i] * ambient[i]);
      return hn::MulAdd(hn::Mul(diffuse, hn::Set(d, material.diffuse[i])), color,
                        hn::MulAdd(specular, hn::Set(d, material.specular[i]), unlit));
    };
    c.r = channel(c.r, sums.diffuse.x, sums.specular.x, 0);
    c.g = channel(c.g, sums.diffuse.y, sums.specular.y, 1);
    c.b = channel(c.b, sums.diffuse.z, sums.specular.z, 2);
  }

  const scene::VolumeShading& shading_;
  const SampleIllumination* arriving_;
};

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#endif
