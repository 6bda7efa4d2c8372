// OpenGL's lighting equation, vectorised. Part of kernels.cpp (compiled once for each instruction set).
#if defined(GLURAY_RENDER_LIGHT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_LIGHT_INL_H_
#undef GLURAY_RENDER_LIGHT_INL_H_
#else
#define GLURAY_RENDER_LIGHT_INL_H_
#endif

#include <hwy/highway.h>
// The order matters: Highway's own inclusion toggles.
#include "render/local/group.h"
#include "render/local/lighting.h"

#include <hwy/contrib/math/math-inl.h>

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = hn::CappedTag<float, kLanes>;
using Float = hn::Vec<FloatTag>;

struct Float3 {
  Float x, y, z;
};

HWY_INLINE Float splat(float v) { return hn::Set(FloatTag(), v); }
HWY_INLINE Float3 splat(const glm::vec3& v) { return {splat(v.x), splat(v.y), splat(v.z)}; }
HWY_INLINE Float clamp01(Float v) { return hn::Min(hn::Max(v, hn::Zero(FloatTag())), splat(1)); }
HWY_INLINE Float dot(const Float3& a, const Float3& b) {
  return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}
HWY_INLINE Float3 scaled(const Float3& a, Float s) {
  return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s)};
}
HWY_INLINE Float3 add(const Float3& a, const Float3& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
HWY_INLINE Float3 sub(const Float3& a, const Float3& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
/// 1/|a|, at most 1e19, so that a vector of length 0 stays 0.
HWY_INLINE Float inverseLength(const Float3& a) {
  return hn::Div(splat(1), hn::Sqrt(hn::Max(dot(a, a), splat(1.2e-38f))));
}
HWY_INLINE Float3 unit(const Float3& a) { return scaled(a, inverseLength(a)); }

/// base^exponent for base in [0, 1], exponent >= 0, with 0^0 = 1.
HWY_INLINE Float power(Float base, Float exponent) {
  const FloatTag d;
  const auto zeroBase = hn::Lt(base, splat(1e-30f));
  const Float safe = hn::IfThenElse(zeroBase, splat(1), base);
  const Float result = hn::Exp(d, hn::Mul(exponent, hn::Log(d, safe)));
  const Float atZero = hn::IfThenElse(hn::Eq(exponent, hn::Zero(d)), splat(1), hn::Zero(d));
  return hn::IfThenElse(zeroBase, atZero, result);
}

/// Primary colour (RGBA), and separately the specular part, which may be added after texturing. Clamped to
/// [0, 1].
struct Lit {
  Float3 primary;
  Float alpha;
  Float3 secondary;
};

/// One material in every lane.
struct UniformMaterial {
  const scene::Material& m;
  HWY_INLINE Float3 emission() const { return splat(glm::vec3(m.emission)); }
  HWY_INLINE Float3 ambient() const { return splat(glm::vec3(m.ambient)); }
  HWY_INLINE Float3 diffuse() const { return splat(glm::vec3(m.diffuse)); }
  HWY_INLINE Float3 specular() const { return splat(glm::vec3(m.specular)); }
  HWY_INLINE Float alpha() const { return splat(m.diffuse.a); }
  HWY_INLINE Float shininess() const { return splat(m.shininess); }
  HWY_INLINE bool specularOn() const { return glm::vec3(m.specular) != glm::vec3(0); }
};

/// Rows of a material that differs from lane to lane.
enum MaterialRow {
  kEmission = 0,
  kAmbient = 3,
  kDiffuse = 6,
  kAlpha = 9,
  kSpecular = 10,
  kShininess = 13,
  kRows = 14
};
struct LaneMaterial {
  const float (*rows)[kLanes];
  int first;  // lane of the vector's first element
  HWY_INLINE Float at(int row) const { return hn::Load(FloatTag(), rows[row] + first); }
  HWY_INLINE Float3 at3(int row) const { return {at(row), at(row + 1), at(row + 2)}; }
  HWY_INLINE Float3 emission() const { return at3(kEmission); }
  HWY_INLINE Float3 ambient() const { return at3(kAmbient); }
  HWY_INLINE Float3 diffuse() const { return at3(kDiffuse); }
  HWY_INLINE Float3 specular() const { return at3(kSpecular); }
  HWY_INLINE Float alpha() const { return at(kAlpha); }
  HWY_INLINE Float shininess() const { return at(kShininess); }
  HWY_INLINE bool specularOn() const { return true; }
};

/// How much of each light arrives at a hit, and what comes from all sides besides: in the local look all and
/// nothing. Integrators shade with a policy of their own (integrators/relit_look.cpp).
struct AllLight {
  /// For the lanes from i on.
  HWY_INLINE AllLight at(int) const { return {}; }
  /// What of `color` light number `light` of the surface's shading leaves.
  HWY_INLINE Float3 arriving(size_t, const Float3& color) const { return color; }
  /// What counts for the diffuse part: attenuation times cosine, of lights without a size.
  HWY_INLINE Float diffuse(size_t, Float share, const Float3&) const { return share; }
  static constexpr bool kHasSizes = false;  // whether diffuse() may return something else
  /// Adds what a surface of this colour and normal reflects of the light from all sides.
  HWY_INLINE Float3 withDome(const Float3& sum, const Float3&, const Float3&) const { return sum; }
};

/// One light at points `p`: unit vector towards it, and attenuation times spot factor.
struct Incoming {
  Float3 direction;
  Float factor;
};

HWY_INLINE Incoming incoming(const PreparedLight& light, const Float3& p) {
  if (light.directional && !light.spot) return {splat(light.position), splat(1)};
  Incoming in{splat(light.position), splat(1)};
  if (!light.directional) {
    const Float3 towards = sub(in.direction, p);
    in.direction = unit(towards);
    if (light.attenuated) {
      const Float distance = hn::Sqrt(dot(towards, towards));
      const Float sum =
          hn::MulAdd(hn::MulAdd(splat(light.attenuation.z), distance, splat(light.attenuation.y)), distance,
                     splat(light.attenuation.x));
      in.factor = hn::Div(splat(1), sum);
    }
  }
  if (light.spot) {
    const Float cosine = hn::Neg(dot(in.direction, splat(light.spotDirection)));
    const Float inside = power(hn::Max(cosine, hn::Zero(FloatTag())), splat(light.spotExponent));
    const auto lit = hn::Ge(cosine, splat(light.spotCosCutoff));
    in.factor = hn::IfThenElseZero(lit, hn::Mul(in.factor, inside));
  }
  return in;
}

/// The lighting equation at points with eye-space position p (read only where lighting.needsPosition) and
/// normal n. Source: GL 2.1, 2.14.1.
template <class Material, class Seen = AllLight>
HWY_INLINE Lit light(const Lighting& lighting, const Float3& p, const Float3& n, const Material& material,
                     const Seen& seen = {}) {
  const Float zero = hn::Zero(FloatTag());
  const Float3 ambient = material.ambient(), diffuse = material.diffuse(), e = material.emission();
  const auto addScaled = [](Float3& sum, const Float3& color, const glm::vec3& by, Float factor) HWY_ATTR {
    sum.x = hn::MulAdd(hn::Mul(color.x, splat(by.x)), factor, sum.x);
    sum.y = hn::MulAdd(hn::Mul(color.y, splat(by.y)), factor, sum.y);
    sum.z = hn::MulAdd(hn::Mul(color.z, splat(by.z)), factor, sum.z);
  };
  Float3 primary = e, secondary{zero, zero, zero};
  addScaled(primary, ambient, lighting.globalAmbient, splat(1));
  primary = seen.withDome(primary, diffuse, n);
  const bool localViewer = lighting.shading->localViewer;
  for (size_t index = 0; index < lighting.lights.size(); ++index) {
    const PreparedLight& l = lighting.lights[index];
    const Incoming in = incoming(l, p);
    const Float cosine = hn::Max(dot(n, in.direction), zero);
    addScaled(primary, ambient, l.ambient, in.factor);
    addScaled(primary, seen.arriving(index, diffuse), l.diffuse,
              seen.diffuse(index, hn::Mul(in.factor, cosine), n));
    if (!l.specularOn || !material.specularOn()) continue;
    Float3 half;
    if (localViewer)
      half = unit(sub(in.direction, unit(p)));
    else if (l.directional)
      half = splat(l.halfVector);
    else
      half = unit(add(in.direction, splat(glm::vec3(0, 0, 1))));
    const Float shine = power(hn::Min(hn::Max(dot(n, half), zero), splat(1e18f)), material.shininess());
    addScaled(secondary, seen.arriving(index, material.specular()), l.specular,
              hn::IfThenElseZero(hn::Gt(cosine, zero), hn::Mul(in.factor, shine)));
  }
  if (!lighting.shading->separateSpecular) {
    primary = add(primary, secondary);
    secondary = {zero, zero, zero};
  }
  return {{clamp01(primary.x), clamp01(primary.y), clamp01(primary.z)},
          clamp01(material.alpha()),
          {clamp01(secondary.x), clamp01(secondary.y), clamp01(secondary.z)}};
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
