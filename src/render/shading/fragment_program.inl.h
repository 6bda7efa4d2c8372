// Colours of fragment programs (scene/fragment_shading.h). Part of kernels.cpp (compiled once for each
// instruction set).
#if defined(GLURAY_RENDER_FRAGMENT_PROGRAM_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_FRAGMENT_PROGRAM_INL_H_
#undef GLURAY_RENDER_FRAGMENT_PROGRAM_INL_H_
#else
#define GLURAY_RENDER_FRAGMENT_PROGRAM_INL_H_
#endif

#include "render/shading/fragment_inputs.inl.h"
#include "render/shading/matcap.h"
#include "render/shading/microfacets.inl.h"
#include "render/shading/separate_microfacets.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// The specular factor, without colours.
HWY_INLINE Float highlight(const scene::FragmentShading& f, const scene::FragmentLight& light,
                           const Float3& way, const Fragment& at, Float cosine, float shininess) {
  if (light.kind == scene::FragmentLight::headlight) return power(cosine, splat(shininess));
  Float base;
  const Float3 toViewer = f.infiniteViewer ? splat(glm::vec3(0, 0, 1)) : at.toViewer;
  if (f.specular == scene::FragmentShading::Specular::ofLight) {
    base = hn::Max(dot(at.normal, splat(light.half)), splat(0));
  } else if (f.specular == scene::FragmentShading::Specular::half) {
    base = hn::Max(dot(at.normal, unit(sub(toViewer, way))), splat(0));
  } else {
    const Float twice = hn::Mul(splat(2), dot(at.normal, way));
    base = hn::Max(dot(sub(way, scaled(at.normal, twice)), toViewer), splat(1e-5f));
  }
  return power(base, splat(shininess));
}

inline bool paintsEdges(const scene::FragmentShading& f) { return f.edges && !f.edgesAlone; }

/// Edges are emissive: they replace the surface's light by their own.
HWY_INLINE void paintEdge(const scene::FragmentShading& f, const Fragment& at, Float3& ambient,
                          Float3& diffuse) {
  const Float rest = hn::Sub(splat(1), at.edge);
  diffuse = scaled(diffuse, rest);
  ambient = add(scaled(ambient, rest), scaled(splat(f.edgeColor), at.edge));
}

HWY_INLINE Float3 atMostOne(const Float3& v) {
  const Float one = splat(1);
  return {hn::Min(v.x, one), hn::Min(v.y, one), hn::Min(v.z, one)};
}

HWY_INLINE Float3 highlightColor(const scene::FragmentShading& f, const scene::Material& m,
                                 const Fragment& at) {
  using Color = scene::FragmentShading::HighlightColor;
  const Float3 color = splat(glm::vec3(m.specular));
  if (f.highlightColor == Color::base) return times(color, at.color);
  if (f.highlightColor == Color::complement) return times(color, sub(splat(glm::vec3(1)), at.color));
  return color;
}

template <class Seen>
HWY_INLINE Float3 phong(const Surface& s, const scene::Material& m, const Fragment& at, const Seen& seen) {
  const Lighting& lighting = *s.lighting;
  const scene::FragmentShading& f = lighting.shading->fragment;
  const Float zero = splat(0);
  Float3 diffuse{zero, zero, zero}, specular{zero, zero, zero}, own{zero, zero, zero};
  bool owns = false;  // some lights have their own highlights
  const bool shines = glm::vec3(m.specular) != glm::vec3(0);
  for (size_t l = 0; l < f.lights.size(); ++l) {
    const scene::FragmentLight& light = f.lights[l];
    const Incoming in = arriving(light, lighting.coneCosines[l], at.position);
    const Float facing = hn::Neg(dot(at.normal, in.direction));
    const Float cosine = f.twoSidedLights ? hn::Abs(facing) : hn::Max(zero, facing);
    const Float3 color = seen.arriving(l, splat(light.color));
    diffuse = add(diffuse, scaled(color, seen.diffuse(l, hn::Mul(cosine, in.factor), at.normal)));
    if (!shines && !light.ownHighlight) continue;
    const float shininess = light.ownHighlight ? light.shininess : m.shininess;
    const Float shine = highlight(f, light, in.direction, at, cosine, shininess);
    const auto lit = hn::Gt(f.highlightsInDark ? in.factor : hn::Mul(cosine, in.factor), zero);
    const Float weight = hn::IfThenElseZero(lit, hn::Mul(in.factor, shine));
    if (light.ownHighlight)
      own = add(own, scaled(seen.arriving(l, splat(light.highlight)), weight)), owns = true;
    else
      specular = add(specular, scaled(color, weight));
  }
  specular = times(specular, highlightColor(f, m, at));
  if (owns) specular = add(specular, own);
  if (f.darkBackFaces) diffuse = scaled(diffuse, at.front), specular = scaled(specular, at.front);
  diffuse = seen.withDome(diffuse, splat(glm::vec3(1)), at.normal);
  Float3 ambient = splat(glm::vec3(m.ambient)), reflected = times(diffuse, splat(glm::vec3(m.diffuse)));
  if (f.clampsLight) reflected = atMostOne(add(ambient, reflected)), ambient = {zero, zero, zero};
  if (!f.colorIsDiffuseOnly) ambient = times(ambient, at.color);
  reflected = times(reflected, at.color);
  if (paintsEdges(f)) paintEdge(f, at, ambient, reflected);
  return add(add(ambient, reflected), specular);
}

HWY_INLINE Float3 unlit(const scene::FragmentShading& f, const scene::Material& m, const Fragment& at) {
  Float3 ambient = splat(glm::vec3(m.ambient)), diffuse = times(splat(glm::vec3(m.diffuse)), at.color);
  if (!f.colorIsDiffuseOnly) ambient = times(ambient, at.color);
  if (paintsEdges(f)) paintEdge(f, at, ambient, diffuse);
  return add(ambient, diffuse);
}

/// A colour for a normal: half of it plus a half.
HWY_INLINE Float3 halfway(const Float3& n) {
  const auto half = [](Float v) HWY_ATTR { return hn::MulAdd(v, splat(0.5f), splat(0.5f)); };
  return {half(n.x), half(n.y), half(n.z)};
}

HWY_INLINE Float rimWeight(const scene::Rim& rim, const Float3& n) {
  return power(clamp01(hn::MulAdd(n.x, n.x, hn::Mul(n.y, n.y))), splat(rim.exponent));
}

/// Changes colour and alpha of a vector of lanes towards silhouettes.
HWY_INLINE void applyRim(const scene::Rim& rim, const Float3& n, Float3& color, float* alpha) {
  const Float weight = rimWeight(rim, n);
  if (rim.mixes) color = add(color, scaled(sub(splat(rim.color), color), weight));
  if (rim.opacity == 0) return;
  const Float more = hn::MulAdd(weight, splat(rim.opacity), splat(1));
  store(hn::Min(hn::Mul(load(alpha), more), splat(1)), alpha);
}

/// The unlit colours of a vector of lanes; bits of `back`: see runProgram().
HWY_ATTR inline Float3 shownColor(const scene::FragmentShading& f, const scene::Material& m,
                                  const Fragment& at, uint32_t back, int i) {
  Float3 color = unlit(f, m, at);
  if (!f.matcap.empty()) {
    alignas(64) Row rows[3], normal[3];
    store(color.x, rows[0]), store(color.y, rows[1]), store(color.z, rows[2]);
    store(at.normal.x, normal[0]), store(at.normal.y, normal[1]), store(at.normal.z, normal[2]);
    for (int l = 0; l < lanesOfVector(); ++l) {
      const glm::vec3 seen =
          throughMatcap(f, {rows[0][l], rows[1][l], rows[2][l]}, {normal[0][l], normal[1][l], normal[2][l]});
      for (int c = 0; c < 3; ++c) rows[c][l] = seen[c];
    }
    color = load3(rows, 0);
  }
  if (f.backFactor != 1)
    color = scaled(color, hn::IfThenElse(lanesAt(back, i), splat(f.backFactor), splat(1)));
  return f.encoding != 1 ? raised(color, 1 / f.encoding) : color;
}

/// Colours of the group from its fragment program, before textures; bit i of `back`: lane i shows its back
/// face.
template <class Seen>
HWY_ATTR inline void runProgram(const FrameData& frame, const Surface& s, const Group& group, uint32_t back,
                                bool backMaterial, const float* x, const float* y, const Seen& seen,
                                LitRows& rows) {
  using Shading = scene::FragmentShading;
  const Shading& f = s.lighting->shading->fragment;
  const scene::Material& m = backMaterial ? s.materials[0].back : s.materials[0].front;
  alignas(64) Row base[4];
  alignas(64) Row normals[3];
  if (f.color == Shading::Color::map)
    lookUpMap(s, group, base);
  else
    loadBaseColor(s, group, base);
  if (f.ignoresAlpha) std::fill_n(base[3], kLanes, 1.0f);
  if (f.colorExponent != 1) raise(f.colorExponent, base);
  if (f.texturesFirst && !s.lighting->shading->textures.empty())
    multiplyByTextures(frame, s, group, f.texturesOnBack ? group.lanes : group.lanes & ~back, x, y, base,
                       f.texturesKeepAlpha ? 3 : 4);
  alignas(64) Row edges;
  if (f.edges) edgeShares(frame, s, group, x, y, edges);
  const bool lit = f.model != Shading::Model::unlit, impostors = s.mesh->shape != scene::Shape::triangles;
  PbrRows maps;
  const bool mapped = !f.pbr.textures.empty() && f.model == Shading::Model::pbr;
  if (mapped) loadPbrTexels(frame, s, group, x, y, maps);
  const bool shaped = lit || !f.matcap.empty();  // the normal counts
  const bool eyeNormals = f.unitNormals != Shading::UnitNormals::pixels || f.facesViewer;
  if (eyeNormals || f.normalColors || f.rim.on)
    loadEyeNormals(s, group, normals);
  else if (shaped && !impostors && f.normals != Shading::Normals::triangles)
    loadNormals(s, group, normals);
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const Weights weights(group, i);
    Fragment at;
    at.color = load3(base, i);
    if (impostors) at.color = scaled(at.color, load(group.fade + i));
    if (f.normalColors) at.color = halfway(load3(normals, i));
    if (f.rim.on) applyRim(f.rim, load3(normals, i), at.color, base[3] + i);
    at.edge = f.edges ? load(edges + i) : splat(0);
    at.front = f.darkBackFaces ? hn::IfThenZeroElse(lanesAt(back, i), splat(1)) : splat(1);
    Float3 color;
    if (shaped) {
      at.position = impostors
                        ? load3(group.point, i)
                        : weights(pointIn(s, group, 0, i), pointIn(s, group, 1, i), pointIn(s, group, 2, i));
      at.toViewer = unit(scaled(at.position, splat(-1)));
      if (impostors) {
        at.normal = load3(group.normal, i);
      } else if (f.normals == Shading::Normals::triangles) {
        at.normal = triangleNormal(s, group, i, at.position);
        if (f.flipsTriangles) at.normal = signedBy(hn::Not(lanesAt(back, i)), at.normal);
      } else {
        at.normal = eyeNormals ? load3(normals, i) : transform(s.instance->normalMatrix, load3(normals, i));
        if (f.unitNormals != Shading::UnitNormals::vertices) at.normal = unit(at.normal);
        if (f.flipBackFaces) at.normal = signedBy(hn::Not(lanesAt(back, i)), at.normal);
      }
    }
    if (f.model == Shading::Model::pbr)
      color = f.pbr.masking == scene::PbrSurface::Masking::separate
                  ? separateMicrofacets(s, m, at, seen.at(i))
                  : microfacets(s, m, at, mapped ? texelsAt(s, maps, i, at) : constantsOf(f.pbr), seen.at(i));
    else
      color = lit ? phong(s, m, at, seen.at(i)) : shownColor(f, m, at, back, i);
    Float alpha = hn::Mul(splat(m.diffuse.a), load(base[3] + i));
    if (impostors && s.instance->impostors.fillsBillboard()) alpha = hn::Mul(alpha, load(group.alpha + i));
    if (f.edges && f.edgesAlone) alpha = hn::Mul(alpha, at.edge);
    rows.set(i, {color, alpha, {splat(0), splat(0), splat(0)}});
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
