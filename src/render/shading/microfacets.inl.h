// Physically based shading of fragment programs. Part of kernels.cpp (compiled once for each instruction
// set).
#if defined(GLURAY_RENDER_MICROFACETS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_MICROFACETS_INL_H_
#undef GLURAY_RENDER_MICROFACETS_INL_H_
#else
#define GLURAY_RENDER_MICROFACETS_INL_H_
#endif

#include "render/shading/fragment_inputs.inl.h"
#include "render/shading/pbr_environment.h"
#include "render/shading/pbr_textures.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// Direction from light to surface, and the attenuation by distance and cone.
HWY_INLINE Incoming arriving(const scene::FragmentLight& light, float coneCosine, const Float3& p) {
  if (light.kind != scene::FragmentLight::positional) return {splat(light.direction), splat(1)};
  const Float3 way = sub(p, splat(light.position));
  const Float distance = hn::Sqrt(dot(way, way));
  const Float sum = hn::MulAdd(hn::MulAdd(splat(light.attenuation.z), distance, splat(light.attenuation.y)),
                               distance, splat(light.attenuation.x));
  Incoming in{unit(way), hn::Div(splat(1), sum)};
  if (light.coneAngle < 90) {
    const Float cosine = dot(in.direction, splat(light.direction));
    const Float inside = power(hn::Max(cosine, splat(0)), splat(light.exponent));
    in.factor = hn::IfThenElseZero(hn::Ge(cosine, splat(coneCosine)), hn::Mul(in.factor, inside));
  }
  return in;
}

/// The direction that a mirror of this normal sends light to that comes along -v; both unit length.
HWY_INLINE Float3 mirrored(const Float3& v, const Float3& normal) {
  return sub(scaled(normal, hn::Mul(splat(2), dot(normal, v))), v);
}

/// Values of a physically based material at a vector of lanes.
struct PbrValues {
  Float metallic, roughness;
  Float visible;  // factor of all light but the emitted
  Float3 emissive;
};

HWY_INLINE PbrValues constantsOf(const scene::PbrSurface& pbr) {
  return {splat(pbr.metallic), splat(pbr.roughness), splat(1), splat(pbr.emissive)};
}

/// What the textures give, lane by lane.
struct PbrRows {
  alignas(64) Row occlusion, roughness, metallic, emission[3], normal[3], tangent[3];
};

HWY_ATTR inline void loadPbrTexels(const FrameData& frame, const Surface& s, const Group& group,
                                   const float* x, const float* y, PbrRows& out) {
  PbrTextures textures(s, frame.snapshot->camera);
  for (int i = 0; i < kLanes; ++i) {
    PbrTexels t;
    if (group.lanes >> i & 1)
      t = textures.at(group.primitive[i], group.u[i], group.v[i], {x[i], y[i]},
                      group.steps ? group.steps + i : nullptr);
    out.occlusion[i] = t.occlusion, out.roughness[i] = t.roughness, out.metallic[i] = t.metallic;
    for (int c = 0; c < 3; ++c)
      out.emission[c][i] = t.emission[c], out.normal[c][i] = t.normal[c], out.tangent[c][i] = t.tangent[c];
  }
}

/// The material's values with its textures; bends the normal by the normal map.
HWY_INLINE PbrValues texelsAt(const Surface& s, const PbrRows& rows, int i, Fragment& at) {
  const scene::PbrSurface& pbr = s.lighting->shading->fragment.pbr;
  if (pbr.normal >= 0) {
    const Float3 tangent = transform(s.instance->normalMatrix, load3(rows.tangent, i)), n = at.normal;
    const Float3 t = unit(sub(tangent, scaled(n, dot(tangent, n)))), b = cross(n, t);
    at.normal = unit(add(add(scaled(t, load(rows.normal[0] + i)), scaled(b, load(rows.normal[1] + i))),
                         scaled(n, load(rows.normal[2] + i))));
  }
  const Float lost = hn::Mul(splat(pbr.occlusionStrength), hn::Sub(splat(1), load(rows.occlusion + i)));
  return {hn::Mul(splat(pbr.metallic), load(rows.metallic + i)),
          hn::Mul(splat(pbr.roughness), load(rows.roughness + i)), hn::Sub(splat(1), lost),
          times(splat(pbr.emissive), load3(rows.emission, i))};
}

/// Factors of the environment's mirrored light and of its irradiance.
struct Shares {
  Float3 glossy, matte;
};

/// These factors with multiple scattering (scene::PbrEnvironment::diffuseF0). `straight`, `grazing`: shares
/// of the reflectances at normal and at grazing incidence.
HWY_INLINE Shares scatteredOften(float diffuseF0, const PbrValues& values, const Float3& albedo,
                                 const Float3& f0, const Float3& f90, Float nv, Float straight,
                                 Float grazing) {
  const Float one = splat(1), smooth = hn::Sub(one, values.roughness), away = hn::Sub(one, nv),
              away2 = hn::Mul(away, away), away5 = hn::Mul(hn::Mul(away2, away2), away);
  const Float lost = hn::Sub(one, hn::Add(straight, grazing));
  const Float matte = hn::Mul(hn::Sub(one, values.metallic), splat(1 - diffuseF0));
  Shares out;
  const auto channel = [&](Float r0, Float r90, Float color, Float& glossy, Float& rest) HWY_ATTR {
    const Float reflectance = hn::MulAdd(hn::Sub(hn::Max(smooth, r0), r0), away5, r0);
    glossy = hn::MulAdd(reflectance, straight, hn::Mul(r90, grazing));
    const Float mean = hn::MulAdd(hn::Sub(one, r0), splat(1 / 21.0f), r0);
    const Float again =
        hn::Div(hn::Mul(hn::Mul(lost, glossy), mean), hn::Max(hn::NegMulAdd(mean, lost, one), splat(1e-5f)));
    const Float through = hn::Sub(hn::Sub(one, glossy), again);
    rest = hn::MulAdd(hn::Mul(matte, color), through, again);
  };
  channel(f0.x, f90.x, albedo.x, out.glossy.x, out.matte.x);
  channel(f0.y, f90.y, albedo.y, out.glossy.y, out.matte.y);
  channel(f0.z, f90.z, albedo.z, out.glossy.z, out.matte.z);
  return out;
}

/// Diffuse and specular light from the environment.
HWY_ATTR inline Float3 environmentLight(const scene::PbrEnvironment& environment, const Fragment& at,
                                        const PbrValues& values, const Float3& albedo, const Float3& f0,
                                        const Float3& f90, Float nv) {
  alignas(64) Row normal[3], way[3], cosine, roughness, irradiance[3], light[3], shares[2];
  const Float3 ahead = mirrored(at.toViewer, at.normal);
  store(at.normal.x, normal[0]), store(at.normal.y, normal[1]), store(at.normal.z, normal[2]);
  store(ahead.x, way[0]), store(ahead.y, way[1]), store(ahead.z, way[2]);
  store(nv, cosine), store(values.roughness, roughness);
  for (int i = 0; i < lanesOfVector(); ++i) {
    const glm::vec3 arriving = irradianceOf(environment, {normal[0][i], normal[1][i], normal[2][i]});
    const glm::vec3 glossy = prefilteredFrom(environment, {way[0][i], way[1][i], way[2][i]}, roughness[i]);
    const glm::vec2 share = reflectedShares(environment, cosine[i], roughness[i]);
    for (int c = 0; c < 3; ++c) irradiance[c][i] = arriving[c], light[c][i] = glossy[c];
    shares[0][i] = share.x, shares[1][i] = share.y;
  }
  const Float one = splat(1);
  Shares reflected{add(scaled(f0, load(shares[0])), scaled(f90, load(shares[1]))),
                   scaled(times(sub({one, one, one}, f0), albedo), hn::Sub(one, values.metallic))};
  if (environment.diffuseF0 >= 0)
    reflected =
        scatteredOften(environment.diffuseF0, values, albedo, f0, f90, nv, load(shares[0]), load(shares[1]));
  const Float3 sum =
      add(times(reflected.matte, load3(irradiance, 0)), times(load3(light, 0), reflected.glossy));
  return scaled(sum, splat(environment.intensity));
}

/// Physically based shading of VTK 9: GGX distribution, height-correlated Smith visibility, Schlick's Fresnel
/// term, Lambertian diffuse, prefiltered light of an environment; the result is gamma-encoded with 1/2.2.
template <class Seen>
HWY_INLINE Float3 microfacets(const Surface& s, const scene::Material& m, const Fragment& at,
                              const PbrValues& values, const Seen& seen) {
  constexpr float kInversePi = 0.31830988618f;
  const Lighting& lighting = *s.lighting;
  const scene::FragmentShading& f = lighting.shading->fragment;
  const scene::PbrSurface& pbr = f.pbr;
  const Float zero = splat(0), one = splat(1), least = splat(1e-5f);
  const auto clamped = [&](Float v) HWY_ATTR { return hn::Min(hn::Max(v, least), one); };
  const auto mix = [&](const Float3& a, const Float3& b, Float w)
                       HWY_ATTR { return add(scaled(a, hn::Sub(one, w)), scaled(b, w)); };
  Float3 albedo = times(splat(glm::vec3(m.diffuse)), at.color);
  if (f.edges && !f.edgesAlone)
    albedo = scaled(albedo, hn::Sub(one, at.edge));  // the program ignores the edge colour
  const Float3 f0 = mix(splat(glm::vec3(pbr.baseF0)), albedo, values.metallic);
  const Float grey = hn::Min(hn::Max(hn::Mul(splat(16.5f), hn::Add(hn::Add(f0.x, f0.y), f0.z)), zero), one);
  const Float3 f90 = mix({grey, grey, grey}, splat(pbr.edgeTint), values.metallic);
  const Float a2 = hn::Mul(values.roughness, values.roughness), a4 = hn::Mul(a2, a2);
  const Float matteShare = hn::Mul(hn::Sub(one, values.metallic), splat(kInversePi));
  const Float nv = clamped(dot(at.normal, at.toViewer));
  Float3 sum{zero, zero, zero};
  for (size_t l = 0; l < f.lights.size(); ++l) {
    const Incoming in = arriving(f.lights[l], lighting.coneCosines[l], at.position);
    const Float3 towards = unit(scaled(in.direction, splat(-1))), half = unit(add(at.toViewer, towards));
    const Float hl = clamped(dot(half, towards)), nl = clamped(dot(at.normal, towards)),
                nh = clamped(dot(at.normal, half));
    const Float d = hn::MulAdd(hn::MulSub(nh, a4, nh), nh, one);
    const Float divisor = hn::Max(splat(pbr.distributionFloor * kInversePi), hn::Mul(d, d));
    const Float distribution = hn::Div(hn::Mul(a4, splat(kInversePi)), divisor);
    const auto smith = [&](Float x, Float y) HWY_ATTR {
      return hn::Mul(y, hn::Sqrt(hn::MulAdd(x, hn::NegMulAdd(a2, x, x), a2)));
    };
    const Float visibility = hn::Div(splat(0.5f), hn::Add(smith(nv, nl), smith(nl, nv)));
    const Float away = hn::Sub(one, hl), away2 = hn::Mul(away, away),
                away5 = hn::Mul(hn::Mul(away2, away2), away);
    const Float3 fresnel = add(f0, scaled(sub(f90, f0), away5));
    const Float3 specular = scaled(fresnel, hn::Mul(distribution, visibility));
    const Float3 through = scaled(sub({one, one, one}, fresnel), matteShare);
    const Float3 color = seen.arriving(l, splat(f.lights[l].color));
    const Float3 radiance = scaled(color, hn::Mul(in.factor, nl));
    if constexpr (Seen::kHasSizes) {
      const Float3 matte = scaled(color, seen.diffuse(l, hn::Mul(in.factor, nl), at.normal));
      sum = add(sum, add(times(matte, times(through, albedo)), times(radiance, specular)));
    } else {
      sum = add(sum, times(radiance, add(times(through, albedo), specular)));
    }
  }
  const Float3 matte = times(sub({one, one, one}, f0), albedo);
  sum = seen.withDome(sum, scaled(matte, matteShare), at.normal);
  sum = seen.withDome(sum, scaled(f0, splat(kInversePi)), mirrored(at.toViewer, at.normal));
  if (pbr.environment.on())
    sum = add(sum, environmentLight(pbr.environment, at, values, albedo, f0, f90, nv));
  sum = add(scaled(sum, values.visible), values.emissive);
  const Float gamma = splat(1 / 2.2f);
  const auto encoded = [&](Float v) HWY_ATTR { return power(hn::Max(v, zero), gamma); };
  return {encoded(sum.x), encoded(sum.y), encoded(sum.z)};
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
