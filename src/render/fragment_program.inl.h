// Colours as fragment programs compute them (scene/fragment_shading.h). Part of kernels.cpp (compiled once
// for each instruction set).
#if defined(GLURAY_RENDER_FRAGMENT_PROGRAM_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_FRAGMENT_PROGRAM_INL_H_
#undef GLURAY_RENDER_FRAGMENT_PROGRAM_INL_H_
#else
#define GLURAY_RENDER_FRAGMENT_PROGRAM_INL_H_
#endif

#include "render/fragment.inl.h"
#include "render/frame_data.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

HWY_INLINE Float3 cross(const Float3& a, const Float3& b) {
  return {hn::NegMulAdd(a.z, b.y, hn::Mul(a.y, b.z)), hn::NegMulAdd(a.x, b.z, hn::Mul(a.z, b.x)),
          hn::NegMulAdd(a.y, b.x, hn::Mul(a.x, b.y))};
}
HWY_INLINE Float3 times(const Float3& a, const Float3& b) {
  return {hn::Mul(a.x, b.x), hn::Mul(a.y, b.y), hn::Mul(a.z, b.z)};
}
/// a where the mask is set, otherwise -a.
HWY_INLINE Float3 signedBy(hn::Mask<FloatTag> keep, const Float3& a) {
  const Float s = hn::IfThenElse(keep, splat(1), splat(-1));
  return scaled(a, s);
}

/// The lanes of a vector that begins at lane i, from bits.
HWY_INLINE hn::Mask<FloatTag> lanesAt(uint32_t lanes, int i) {
  uint8_t bits[8] = {static_cast<uint8_t>(lanes >> i), static_cast<uint8_t>(lanes >> i >> 8)};
  return hn::LoadMaskBits(FloatTag(), bits);
}

/// What a fragment program starts from, for one vector of lanes.
struct Fragment {
  Float3 position;  // the program's eye space
  Float3 toViewer;  // unit length
  Float3 normal;    // unit length, turned to the side that is lit
  Float3 color;     // what the material's colours are multiplied by
  Float edge;       // how much of the edges' colour is seen, 0 .. 1; only where edges are painted
};

/// Colour and alpha of the lanes that a texture, the vertices or an array by triangle gives; ones where the
/// material's colour stands alone.
HWY_ATTR inline void loadBaseColor(const Surface& s, const Group& group, Row (&out)[4]) {
  using Color = scene::FragmentShading::Color;
  const scene::FragmentShading& f = s.lighting->shading->fragment;
  fillRows<4>(glm::vec4(1), out);
  if (f.color == Color::perTriangle) {
    for (int i = 0; i < kLanes; ++i) {
      const glm::vec4 c =
          scene::fetch(s.instance->triangleColors, s.instance->triangleOffset + group.primitive[i]);
      for (int k = 0; k < 4; ++k) out[k][i] = c[k];
    }
  } else if (f.color == Color::vertices && !s.colorsVary) {
    fillRows<4>(s.instance->color, out);
  } else if (f.color == Color::vertices) {
    alignas(64) Row corner[3][4];
    for (int k = 0; k < 3; ++k) loadVec4(s.mesh->colors, group.vertex[k], corner[k]);
    for (int i = 0; i < kLanes; i += lanesOfVector()) {
      const Weights weights(group, i);
      for (int c = 0; c < 4; ++c)
        store(weights(load(corner[0][c] + i), load(corner[1][c] + i), load(corner[2][c] + i)), out[c] + i);
    }
  }
}

HWY_INLINE glm::vec4 unpack(uint32_t texel) {
  return glm::vec4(texel & 255, texel >> 8 & 255, texel >> 16 & 255, texel >> 24) * (1.0f / 255.0f);
}

/// Looks colour maps up: clamped to the edge, one level, nearest or linear.
HWY_ATTR inline void lookUpMap(const Surface& s, const Group& group, Row (&out)[4]) {
  const scene::Texture& map = s.lighting->shading->fragment.map.front();
  const scene::TextureImage& image = *map.image;
  alignas(64) Row at[2];
  alignas(64) Row corner[3][4];
  for (int k = 0; k < 3; ++k) {
    if (s.mesh->texcoords)
      loadVec4(s.mesh->texcoords, group.vertex[k], corner[k]);
    else
      fillRows<4>(s.instance->texcoord, corner[k]);
  }
  const Float size[2] = {splat(static_cast<float>(image.width)), splat(static_cast<float>(image.height))};
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const Weights weights(group, i);
    for (int c = 0; c < 2; ++c) {
      const Float t = weights(load(corner[0][c] + i), load(corner[1][c] + i), load(corner[2][c] + i));
      store(hn::Mul(t, size[c]), at[c] + i);
    }
  }
  const auto texel = [&](int x, int y) {
    const size_t i =
        static_cast<size_t>(std::clamp(y, 0, image.height - 1)) * static_cast<size_t>(image.width) +
        static_cast<size_t>(std::clamp(x, 0, image.width - 1));
    return image.texels.empty() ? image.floats[i] : unpack(image.texels[i]);
  };
  const float mostX = static_cast<float>(image.width), mostY = static_cast<float>(image.height);
  for (int i = 0; i < kLanes; ++i) {
    // Comparisons that fail for NaN leave 0.
    const float x = at[0][i] > 0 ? std::min(at[0][i], mostX) : 0,
                y = at[1][i] > 0 ? std::min(at[1][i], mostY) : 0;
    glm::vec4 color;
    if (map.magFilter == scene::Filter::nearest) {
      color = texel(static_cast<int>(x), static_cast<int>(y));
    } else {
      const float fx = std::floor(x - 0.5f), fy = std::floor(y - 0.5f), wx = x - 0.5f - fx,
                  wy = y - 0.5f - fy;
      const int x0 = static_cast<int>(fx), y0 = static_cast<int>(fy);
      color = glm::mix(glm::mix(texel(x0, y0), texel(x0 + 1, y0), wx),
                       glm::mix(texel(x0, y0 + 1), texel(x0 + 1, y0 + 1), wx), wy);
    }
    for (int k = 0; k < 4; ++k) out[k][i] = color[k];
  }
}

HWY_INLINE Float3 pointIn(const Surface& s, const Group& group, int k, int i) {
  return transformPoint(s.instance->lightingFromObject, load3(group.position[k], i));
}

/// Normals that vertices or an array by triangle give, object space.
HWY_ATTR inline void loadNormals(const Surface& s, const Group& group, Row (&out)[3]) {
  if (s.lighting->shading->fragment.normals == scene::FragmentShading::Normals::perTriangle) {
    for (int i = 0; i < kLanes; ++i) {
      const glm::vec4 n =
          scene::fetch(s.instance->triangleNormals, s.instance->triangleOffset + group.primitive[i]);
      for (int k = 0; k < 3; ++k) out[k][i] = n[k];
    }
    return;
  }
  if (!s.mesh->normals) return fillRows<3>(s.instance->normal, out);
  alignas(64) Row corner[3][3];
  for (int k = 0; k < 3; ++k) loadVec3(s.mesh->normals, s.mesh->vertexCount, group.vertex[k], corner[k]);
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const Weights weights(group, i);
    for (int c = 0; c < 3; ++c)
      store(weights(load(corner[0][c] + i), load(corner[1][c] + i), load(corner[2][c] + i)), out[c] + i);
  }
}

/// The triangle's own normal, towards the viewer.
HWY_INLINE Float3 triangleNormal(const Surface& s, const Group& group, int i, const Float3& p) {
  const Float3 a = pointIn(s, group, 0, i);
  const Float3 n = unit(cross(sub(pointIn(s, group, 1, i), a), sub(pointIn(s, group, 2, i), a)));
  if (s.lighting->shading->fragment.parallelView) return signedBy(hn::Ge(n.z, splat(0)), n);
  return signedBy(hn::Le(dot(n, p), splat(0)), n);
}

/// Direction from light to surface, and what distance and cone leave of it.
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

/// The highlight's strength before colours.
HWY_INLINE Float highlight(const scene::FragmentShading& f, const scene::FragmentLight& light,
                           const Float3& way, const Fragment& at, Float cosine, float shininess) {
  if (light.kind == scene::FragmentLight::headlight) return power(cosine, splat(shininess));
  Float base;
  if (f.specular == scene::FragmentShading::Specular::half) {
    base = hn::Max(dot(at.normal, unit(sub(at.toViewer, way))), splat(0));
  } else {
    const Float twice = hn::Mul(splat(2), dot(at.normal, way));
    base = hn::Max(dot(sub(way, scaled(at.normal, twice)), at.toViewer), splat(1e-5f));
  }
  return power(base, splat(shininess));
}

/// Edges give light of their own instead of the surface's.
HWY_INLINE void paintEdge(const scene::FragmentShading& f, const Fragment& at, Float3& ambient,
                          Float3& diffuse) {
  const Float rest = hn::Sub(splat(1), at.edge);
  diffuse = scaled(diffuse, rest);
  ambient = add(scaled(ambient, rest), scaled(splat(f.edgeColor), at.edge));
}

/// Distances in pixels from window positions x, y to the painted edges of their triangles, as shares of
/// colour.
HWY_ATTR inline void edgeShares(const FrameData& frame, const Surface& s, const Group& group, const float* x,
                                const float* y, Row& out) {
  const scene::FragmentShading& f = s.lighting->shading->fragment;
  const glm::ivec4& view = frame.snapshot->camera.viewport;
  const glm::dvec2 scale(view.z * 0.5, view.w * 0.5), centre(view.x + scale.x, view.y + scale.y);
  for (int i = 0; i < kLanes; ++i) {
    const auto flags = static_cast<uint32_t>(
        s.instance->triangleEdges.data[s.instance->triangleOffset + group.primitive[i]]);
    glm::dvec2 corner[3];
    bool before = true;  // the viewer, all corners
    for (int k = 0; k < 3; ++k) {
      const glm::dvec4 clip = s.clipFromObject * glm::dvec4(group.position[k][0][i], group.position[k][1][i],
                                                            group.position[k][2][i], 1);
      before = before && clip.w > 0;
      corner[k] = centre + scale * glm::dvec2(clip) / clip.w;
    }
    double nearest = 1e9;
    for (int k = 0; k < 3 && before; ++k) {
      if (!(flags >> k & 1)) continue;
      const glm::dvec2 along = corner[(k + 1) % 3] - corner[k], to = glm::dvec2(x[i], y[i]) - corner[k];
      const double length = glm::length(along);
      if (length > 0) nearest = std::min(nearest, std::abs(along.x * to.y - along.y * to.x) / length);
    }
    out[i] = static_cast<float>(std::clamp(0.5 + 0.5 * f.edgeWidth - nearest, 0.0, 1.0));
  }
}

HWY_INLINE Float3 phong(const Surface& s, const scene::Material& m, const Fragment& at) {
  const Lighting& lighting = *s.lighting;
  const scene::FragmentShading& f = lighting.shading->fragment;
  const Float zero = splat(0);
  Float3 diffuse{zero, zero, zero}, specular{zero, zero, zero};
  const bool shines = glm::vec3(m.specular) != glm::vec3(0);
  for (size_t l = 0; l < f.lights.size(); ++l) {
    const scene::FragmentLight& light = f.lights[l];
    const Incoming in = arriving(light, lighting.coneCosines[l], at.position);
    const Float cosine = hn::Max(zero, hn::Neg(dot(at.normal, in.direction)));
    diffuse = add(diffuse, scaled(splat(light.color), hn::Mul(cosine, in.factor)));
    if (!shines) continue;
    const Float shine = highlight(f, light, in.direction, at, cosine, m.shininess);
    const auto lit = hn::Gt(hn::Mul(cosine, in.factor), zero);
    specular = add(specular, scaled(splat(light.color), hn::IfThenElseZero(lit, hn::Mul(in.factor, shine))));
  }
  Float3 ambient = splat(glm::vec3(m.ambient));
  if (!f.colorIsDiffuseOnly) ambient = times(ambient, at.color);
  Float3 reflected = times(times(diffuse, splat(glm::vec3(m.diffuse))), at.color);
  if (f.edges) paintEdge(f, at, ambient, reflected);
  return add(add(ambient, reflected), times(specular, splat(glm::vec3(m.specular))));
}

HWY_INLINE Float3 unlit(const scene::FragmentShading& f, const scene::Material& m, const Fragment& at) {
  Float3 ambient = splat(glm::vec3(m.ambient)), diffuse = times(splat(glm::vec3(m.diffuse)), at.color);
  if (!f.colorIsDiffuseOnly) ambient = times(ambient, at.color);
  if (f.edges) paintEdge(f, at, ambient, diffuse);
  return add(ambient, diffuse);
}

/// GGX distribution, height-correlated Smith visibility, Schlick's Fresnel term, Lambert's diffuse part; the
/// result is encoded by 1/2.2. As VTK 9's physically based shading without images has it.
HWY_INLINE Float3 microfacets(const Surface& s, const scene::Material& m, const Fragment& at) {
  constexpr float kInversePi = 0.31830988618f;
  const Lighting& lighting = *s.lighting;
  const scene::FragmentShading& f = lighting.shading->fragment;
  const scene::PbrSurface& pbr = f.pbr;
  const Float zero = splat(0), one = splat(1), least = splat(1e-5f);
  const auto clamped = [&](Float v) HWY_ATTR { return hn::Min(hn::Max(v, least), one); };
  const auto mix = [&](const Float3& a, const Float3& b, float w)
                       HWY_ATTR { return add(scaled(a, splat(1 - w)), scaled(b, splat(w))); };
  const Float3 albedo = times(splat(glm::vec3(m.diffuse)), at.color);
  const Float3 f0 = mix(splat(glm::vec3(pbr.baseF0)), albedo, pbr.metallic);
  const Float grey = hn::Min(hn::Max(hn::Mul(splat(16.5f), hn::Add(hn::Add(f0.x, f0.y), f0.z)), zero), one);
  const Float3 f90 = mix({grey, grey, grey}, splat(pbr.edgeTint), pbr.metallic);
  const float a2 = pbr.roughness * pbr.roughness, a4 = a2 * a2;
  const Float nv = clamped(dot(at.normal, at.toViewer));
  Float3 sum{zero, zero, zero};
  for (size_t l = 0; l < f.lights.size(); ++l) {
    const Incoming in = arriving(f.lights[l], lighting.coneCosines[l], at.position);
    const Float3 towards = unit(scaled(in.direction, splat(-1))), half = unit(add(at.toViewer, towards));
    const Float hl = clamped(dot(half, towards)), nl = clamped(dot(at.normal, towards)),
                nh = clamped(dot(at.normal, half));
    const Float d = hn::MulAdd(hn::MulSub(nh, splat(a4), nh), nh, one);
    const Float distribution = hn::Div(splat(a4 * kInversePi), hn::Mul(d, d));
    const auto smith = [&](Float x, Float y) HWY_ATTR {
      return hn::Mul(y, hn::Sqrt(hn::MulAdd(x, hn::NegMulAdd(splat(a2), x, x), splat(a2))));
    };
    const Float visibility = hn::Div(splat(0.5f), hn::Add(smith(nv, nl), smith(nl, nv)));
    const Float away = hn::Sub(one, hl), away2 = hn::Mul(away, away),
                away5 = hn::Mul(hn::Mul(away2, away2), away);
    const Float3 fresnel = add(f0, scaled(sub(f90, f0), away5));
    const Float3 specular = scaled(fresnel, hn::Mul(distribution, visibility));
    const Float3 through = scaled(sub({one, one, one}, fresnel), splat((1 - pbr.metallic) * kInversePi));
    const Float3 radiance = scaled(splat(f.lights[l].color), hn::Mul(in.factor, nl));
    sum = add(sum, times(radiance, add(times(through, albedo), specular)));
  }
  sum = add(sum, splat(pbr.emissive));
  const Float gamma = splat(1 / 2.2f);
  const auto encoded = [&](Float v) HWY_ATTR { return power(hn::Max(v, zero), gamma); };
  return {encoded(sum.x), encoded(sum.y), encoded(sum.z)};
}

/// Colours of the group by a fragment program, before its textures; bit i of `back`: lane i shows its back
/// face.
HWY_ATTR inline void runProgram(const FrameData& frame, const Surface& s, const Group& group, uint32_t back,
                                bool backMaterial, const float* x, const float* y, LitRows& rows) {
  using Shading = scene::FragmentShading;
  const Shading& f = s.lighting->shading->fragment;
  const scene::Material& m = backMaterial ? s.materials[0].back : s.materials[0].front;
  alignas(64) Row base[4];
  alignas(64) Row normals[3];
  if (f.color == Shading::Color::map)
    lookUpMap(s, group, base);
  else
    loadBaseColor(s, group, base);
  alignas(64) Row edges;
  if (f.edges) edgeShares(frame, s, group, x, y, edges);
  const bool lit = f.model != Shading::Model::unlit;
  if (lit && f.normals != Shading::Normals::triangles) loadNormals(s, group, normals);
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const Weights weights(group, i);
    Fragment at;
    at.color = load3(base, i);
    at.edge = f.edges ? load(edges + i) : splat(0);
    Float3 color;
    if (lit) {
      at.position = weights(pointIn(s, group, 0, i), pointIn(s, group, 1, i), pointIn(s, group, 2, i));
      at.toViewer = unit(scaled(at.position, splat(-1)));
      if (f.normals == Shading::Normals::triangles) {
        at.normal = triangleNormal(s, group, i, at.position);
      } else {
        at.normal = unit(transform(s.instance->normalMatrix, load3(normals, i)));
        if (f.flipBackFaces) at.normal = signedBy(hn::Not(lanesAt(back, i)), at.normal);
      }
      color = f.model == Shading::Model::pbr ? microfacets(s, m, at) : phong(s, m, at);
    } else {
      color = unlit(f, m, at);
    }
    rows.set(i, {color, hn::Mul(splat(m.diffuse.a), load(base[3] + i)), {splat(0), splat(0), splat(0)}});
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
