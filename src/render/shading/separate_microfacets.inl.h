// Physically based shading with separate masking and shadowing. Part of kernels.cpp (compiled once for each
// instruction set).
#if defined(GLURAY_RENDER_SEPARATE_MICROFACETS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_SEPARATE_MICROFACETS_INL_H_
#undef GLURAY_RENDER_SEPARATE_MICROFACETS_INL_H_
#else
#define GLURAY_RENDER_SEPARATE_MICROFACETS_INL_H_
#endif

#include "render/shading/microfacets.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// The specular reflection of one light, and the share of it that enters the surface, a vector of lanes.
struct Reflected {
  Float3 specular, through;
};

/// GGX with Schlick's masking and Fresnel term. `towards`: to the light.
HWY_INLINE Reflected separatelyMasked(const Fragment& at, const Float3& towards, const Float3& f0,
                                      float roughness, Float nl, Float nv) {
  constexpr float kInversePi = 0.31830988618f;
  const Float zero = splat(0), one = splat(1);
  const auto share = [&](Float v) HWY_ATTR { return hn::Min(hn::Max(v, zero), one); };
  const Float3 half = unit(add(towards, at.toViewer));
  const Float nh = share(dot(at.normal, half)), vh = share(dot(at.toViewer, half));
  const float k = (roughness + 1) * (roughness + 1) / 8, a2 = roughness * roughness * roughness * roughness;
  const auto masked = [&](Float x) HWY_ATTR { return hn::Div(x, hn::MulAdd(x, splat(1 - k), splat(k))); };
  const Float d = hn::MulAdd(hn::Mul(nh, nh), splat(a2 - 1), one);
  const Float distribution = hn::Div(splat(a2 * kInversePi), hn::Mul(d, d));
  const Float away = hn::Sub(one, vh), away2 = hn::Mul(away, away),
              away5 = hn::Mul(hn::Mul(away2, away2), away);
  const Float3 fresnel = add(f0, scaled(sub({one, one, one}, f0), away5));
  const Float divisor = hn::MulAdd(hn::Mul(splat(4), nl), nv, splat(0.001f));
  const Float lobe = hn::Div(hn::Mul(hn::Mul(masked(nv), masked(nl)), distribution), divisor);
  return {scaled(fresnel, lobe), sub({one, one, one}, fresnel)};
}

/// Physically based shading as Khronos' first glTF viewer has it, and pyrender: dielectrics reflect 0.04 and
/// scatter the rest of the base colour; vertex colours multiply the sum; the result is gamma-encoded with
/// 1/2.2.
template <class Seen>
HWY_INLINE Float3 separateMicrofacets(const Surface& s, const scene::Material& m, const Fragment& at,
                                      const Seen& seen) {
  constexpr float kInversePi = 0.31830988618f, kDielectric = 0.04f;
  const Lighting& lighting = *s.lighting;
  const scene::FragmentShading& f = lighting.shading->fragment;
  const float roughness = std::clamp(f.pbr.roughness, 0.04f, 1.0f),
              metallic = std::clamp(f.pbr.metallic, 0.0f, 1.0f);
  const glm::vec3 base(m.diffuse);
  const Float3 f0 = splat(glm::mix(glm::vec3(kDielectric), base, metallic)),
               matte = splat(base * ((1 - kDielectric) * (1 - metallic) * kInversePi));
  const auto facing = [](Float v) HWY_ATTR { return hn::Min(hn::Max(v, splat(0.001f)), splat(1)); };
  const Float nv = facing(hn::Abs(dot(at.normal, at.toViewer)));
  Float3 sum = splat(base * f.pbr.ambient + f.pbr.emissive);
  for (size_t l = 0; l < f.lights.size(); ++l) {
    const Incoming in = arriving(f.lights[l], lighting.coneCosines[l], at.position);
    const Float3 towards = scaled(in.direction, splat(-1));
    const Float nl = facing(dot(at.normal, towards)), factor = hn::Mul(in.factor, nl);
    const Reflected reflected = separatelyMasked(at, towards, f0, roughness, nl, nv);
    const Float3 color = seen.arriving(l, splat(f.lights[l].color));
    sum = add(sum, times(scaled(color, seen.diffuse(l, factor, at.normal)), times(reflected.through, matte)));
    sum = add(sum, times(scaled(color, factor), reflected.specular));
  }
  sum = seen.withDome(sum, matte, at.normal);
  sum = times(sum, at.color);
  const auto encoded = [](Float v) HWY_ATTR { return power(hn::Max(v, splat(0)), splat(1 / 2.2f)); };
  return {encoded(sum.x), encoded(sum.y), encoded(sum.z)};
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
