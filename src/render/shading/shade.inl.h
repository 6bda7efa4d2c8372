// Shades hits: attributes, lighting, texturing, RGBA8. Part of kernels.cpp (compiled once for each
// instruction set).
#if defined(GLURAY_RENDER_SHADE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_SHADE_INL_H_
#undef GLURAY_RENDER_SHADE_INL_H_
#else
#define GLURAY_RENDER_SHADE_INL_H_
#endif

#include "render/frame_data/frame_data.h"
#include "render/local/fragment.inl.h"
#include "render/local/material.inl.h"
#include "render/local/textured_triangle.h"
#include "render/shading/fragment_program.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// Vertex attributes of a group's triangles.
struct Attributes {
  alignas(64) Row normal[3][3];
  alignas(64) Row color[3][4];
  alignas(64) Row secondary[3][3];  // only with GL_COLOR_SUM
};

HWY_ATTR inline void loadAttributes(const Surface& s, const Group& group, Attributes& out) {
  const bool normals = s.lighting->shading->lighting;
  const bool colors =
      !normals || (s.colorsVary && s.lighting->shading->colorMaterial != scene::ColorMaterial{});
  for (int k = 0; k < 3; ++k) {
    if (normals && s.mesh->normals)
      loadVec3(s.mesh->normals, s.mesh->vertexCount, group.vertex[k], out.normal[k]);
    else if (normals)
      fillRows<3>(s.instance->normal, out.normal[k]);
    if (colors && s.colorsVary)
      loadVec4(s.mesh->colors, group.vertex[k], out.color[k]);
    else if (colors)
      fillRows<4>(s.instance->color, out.color[k]);
    if (!s.lighting->shading->colorSum) continue;
    if (s.mesh->secondaryColors)
      loadVec3(s.mesh->secondaryColors, s.mesh->vertexCount, group.vertex[k], out.secondary[k]);
    else
      fillRows<3>(s.instance->secondaryColor, out.secondary[k]);
  }
}

HWY_INLINE Float3 sided(const Float3& n, bool back) { return back ? scaled(n, splat(-1)) : n; }

// GL 2.1, 2.11.3: the normal of a corner in eye space.
HWY_INLINE Float3 cornerNormal(const Surface& s, const Float3& n) {
  const Float3 eye = transform(s.eyeFromObjectNormal, n);
  if (s.lighting->shading->normalize) return unit(eye);
  return s.lighting->shading->rescaleNormal ? scaled(eye, splat(s.rescale)) : eye;
}

// The share of a point's normal that comes from corners whose normals, of lengths l0 to l2, have a direction.
// As in vertex lighting, corners without one receive no light of light sources, which fades towards them.
HWY_INLINE Float shareWithDirection(Float l0, Float l1, Float l2, const Weights& weights) {
  const Float zero = splat(0), one = splat(1);
  const auto has = [&](Float length) HWY_ATTR { return hn::IfThenElseZero(hn::Gt(length, zero), one); };
  const auto all = hn::Gt(hn::Min(hn::Min(l0, l1), l2), zero);
  return hn::IfThenElse(all, one, weights(has(l0), has(l1), has(l2)));
}

// The normal inside the triangle. Interpolates directions as unit vectors, and lengths (which matter without
// GL_NORMALIZE) separately, so that highlights do not fade between corners.
HWY_INLINE Float3 pixelNormal(const Surface& s, const Attributes& a, const Weights& weights, int i) {
  const Float3 n0 = load3(a.normal[0], i), n1 = load3(a.normal[1], i), n2 = load3(a.normal[2], i);
  const Float i0 = inverseLength(n0), i1 = inverseLength(n1), i2 = inverseLength(n2);
  const Float3 direction = unit(weights(scaled(n0, i0), scaled(n1, i1), scaled(n2, i2)));
  const Float3 eye = transform(s.eyeFromObjectNormal, direction);
  const scene::Shading& shading = *s.lighting->shading;
  const Float l0 = hn::Mul(dot(n0, n0), i0), l1 = hn::Mul(dot(n1, n1), i1), l2 = hn::Mul(dot(n2, n2), i2);
  if (shading.normalize) return scaled(unit(eye), shareWithDirection(l0, l1, l2, weights));
  const Float length = weights(l0, l1, l2);
  return scaled(eye, shading.rescaleNormal ? hn::Mul(length, splat(s.rescale)) : length);
}

template <class Seen>
HWY_INLINE Lit lightWith(const MaterialChoice& choice, const Lighting& lighting, int i, const Float3& p,
                         const Float3& n, const Seen& seen) {
  if (choice.uniform) return light(lighting, p, n, UniformMaterial{*choice.uniform}, seen.at(i));
  return light(lighting, p, n, LaneMaterial{choice.rows, i}, seen.at(i));
}

// Lighting at corner k, as in OpenGL.
template <class Seen>
HWY_ATTR inline void lightCorner(const Surface& s, const Group& group, const Attributes& a, int k, bool back,
                                 const Seen& seen, LitRows& out) {
  MaterialChoice material;
  chooseMaterial(s, group, k, back, a.color[k], material);
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const Float3 n = sided(cornerNormal(s, load3(a.normal[k], i)), back);
    Float3 p{n};
    if (s.lighting->needsPosition) p = transformPoint(s.eyeFromObject, load3(group.position[k], i));
    out.set(i, lightWith(material, *s.lighting, i, p, n, seen));
  }
}

// Lighting at the points of balls and capsules. Flat: with the colour of the last vertex.
template <class Seen>
HWY_ATTR inline void lightSolids(const Surface& s, const Group& group, const Attributes& a, const Seen& seen,
                                 LitRows& out) {
  alignas(64) Row color[4];
  const bool smooth = s.lighting->shading->smooth;
  for (int i = 0; i < kLanes && s.colorsVary; i += lanesOfVector()) {
    const Weights weights(group, i);
    for (int c = 0; c < 4; ++c) {
      const Float last = load(a.color[2][c] + i);
      store(smooth ? weights(load(a.color[0][c] + i), load(a.color[1][c] + i), last) : last, color[c] + i);
    }
  }
  MaterialChoice material;
  chooseMaterial(s, group, 2, false, color, material);
  for (int i = 0; i < kLanes; i += lanesOfVector())
    out.set(i, lightWith(material, *s.lighting, i, load3(group.point, i), load3(group.normal, i), seen));
}

// Lighting at the hit points.
template <class Seen>
HWY_ATTR inline void lightPixels(const Surface& s, const Group& group, const Attributes& a, bool back,
                                 const Seen& seen, LitRows& out) {
  alignas(64) Row color[4];
  if (s.colorsVary && s.lighting->shading->colorMaterial != scene::ColorMaterial{}) {
    for (int i = 0; i < kLanes; i += lanesOfVector()) {
      const Weights weights(group, i);
      for (int c = 0; c < 4; ++c) {
        store(weights(load(a.color[0][c] + i), load(a.color[1][c] + i), load(a.color[2][c] + i)),
              color[c] + i);
      }
    }
  }
  MaterialChoice material;
  chooseMaterial(s, group, 2, back, color, material);
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const Weights weights(group, i);
    const Float3 n = sided(pixelNormal(s, a, weights, i), back);
    Float3 p{n};
    if (s.lighting->needsPosition) {
      const Float3 object =
          weights(load3(group.position[0], i), load3(group.position[1], i), load3(group.position[2], i));
      p = transformPoint(s.eyeFromObject, object);
    }
    out.set(i, lightWith(material, *s.lighting, i, p, n, seen));
  }
}

// Colour of corner k without lighting.
HWY_ATTR inline void colorCorner(const Attributes& a, int k, bool secondary, LitRows& out) {
  const Float zero = hn::Zero(FloatTag());
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const Float3 color = load3(a.color[k], i);
    out.set(i, {{clamp01(color.x), clamp01(color.y), clamp01(color.z)},
                clamp01(load(a.color[k][3] + i)),
                {zero, zero, zero}});
    for (int c = 0; secondary && c < 3; ++c)
      store(clamp01(load(a.secondary[k][c] + i)), out.value[4 + c] + i);
  }
}

HWY_ATTR inline void interpolate(const Group& group, const LitRows (&corners)[3], LitRows& out) {
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const Weights weights(group, i);
    for (int c = 0; c < 7; ++c) {
      store(weights(load(corners[0].value[c] + i), load(corners[1].value[c] + i),
                    load(corners[2].value[c] + i)),
            out.value[c] + i);
    }
  }
}

// Colours of a group whose lanes all show the same side.
template <class Seen>
HWY_ATTR inline void colorSide(const FrameData& frame, const Surface& s, const Group& group,
                               const Attributes& a, bool back, const Seen& seen, LitRows& out) {
  const scene::Shading& shading = *s.lighting->shading;
  if (scene::isSolid(s.mesh->shape) && shading.lighting) return lightSolids(s, group, a, seen, out);
  const auto corner = [&](int k, LitRows& rows) HWY_ATTR {
    if (shading.lighting)
      lightCorner(s, group, a, k, back, seen, rows);
    else
      colorCorner(a, k, shading.colorSum, rows);
  };
  if (!shading.smooth) return corner(2, out);
  if (shading.lighting && !frame.perVertex) return lightPixels(s, group, a, back, seen, out);
  LitRows corners[3];
  for (int k = 0; k < 3; ++k) corner(k, corners[k]);
  interpolate(group, corners, out);
}

HWY_ATTR inline void textureLanes(const FrameData& frame, const Surface& s, const Group& group,
                                  const float* x, const float* y, LitRows& rows) {
  TexturedTriangle triangle(s, frame.snapshot->camera);
  for (uint32_t lanes = group.lanes; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    const glm::vec4 primary(rows.value[0][i], rows.value[1][i], rows.value[2][i], rows.value[3][i]);
    const glm::vec4 color = triangle.color(group.primitive[i], group.u[i], group.v[i], {x[i], y[i]}, primary,
                                           group.steps ? group.steps + i : nullptr);
    for (int c = 0; c < 4; ++c) rows.value[c][i] = color[c];
  }
}

// Secondary colour added to the primary, GL 2.1, 3.9.
HWY_ATTR inline void addSecondary(bool clamps, LitRows& rows) {
  for (int i = 0; i < kLanes; i += lanesOfVector())
    for (int c = 0; c < 3; ++c) {
      const Float sum = hn::Add(load(rows.value[c] + i), load(rows.value[4 + c] + i));
      store(clamps ? clamp01(sum) : sum, rows.value[c] + i);
    }
}

// RGBA8 with red in the lowest byte.
HWY_ATTR inline void packColors(const LitRows& rows, uint32_t* color) {
  const hn::Rebind<uint32_t, FloatTag> du;
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const auto byte = [&](int c) HWY_ATTR {
      return hn::BitCast(du, hn::NearestInt(hn::Mul(clamp01(load(rows.value[c] + i)), splat(255))));
    };
    const auto packed = hn::Or(hn::Or(byte(0), hn::ShiftLeft<8>(byte(1))),
                               hn::Or(hn::ShiftLeft<16>(byte(2)), hn::ShiftLeft<24>(byte(3))));
    hn::Store(packed, du, color + i);
  }
}

// Colours from the surface's fragment program.
template <class Seen>
HWY_ATTR inline void shadeByProgram(const FrameData& frame, const Surface& s, const Group& group,
                                    uint32_t back, const float* x, const float* y, const Seen& seen,
                                    LitRows& rows) {
  const bool twoMaterials = s.lighting->shading->fragment.backMaterial && (back & group.lanes) != 0;
  runProgram(frame, s, group, back, false, x, y, seen, rows);
  if (twoMaterials) {
    LitRows backRows;
    runProgram(frame, s, group, back, true, x, y, seen, backRows);
    for (uint32_t lanes = back & group.lanes; lanes; lanes &= lanes - 1) {
      const int i = std::countr_zero(lanes);
      for (int c = 0; c < 4; ++c) rows.value[c][i] = backRows.value[c][i];
    }
  }
  const scene::FragmentShading& f = s.lighting->shading->fragment;
  const uint32_t textured = f.texturesOnBack ? group.lanes : group.lanes & ~back;
  if (!s.lighting->shading->textures.empty() && !f.texturesFirst)
    multiplyByTextures(frame, s, group, textured, x, y, rows.value);
  if (s.lighting->shading->fog.mode != scene::Fog::off) applyFog(s, group, rows);
  for (uint32_t lanes = f.paintsBack ? back & group.lanes : 0; lanes; lanes &= lanes - 1)
    for (int c = 0; c < 3; ++c) rows.value[c][std::countr_zero(lanes)] = f.backColor[c];
}

/// Colours (the first four rows) of the group's lanes at window positions x, y; bit i of `back`: lane i shows
/// its back face. Lanes outside the group are undefined. Returns the lanes that fail the alpha test. `seen`:
/// what arrives of the lights.
template <class Seen = AllLight>
HWY_ATTR inline uint32_t shade(const FrameData& frame, const Surface& s, const Group& group, uint32_t back,
                               const float* x, const float* y, LitRows& rows, const Seen& seen = {}) {
  const scene::Shading& shading = *s.lighting->shading;
  if (shading.fragment.model != scene::FragmentShading::Model::off) {
    shadeByProgram(frame, s, group, back, x, y, seen, rows);
    return failingLanes(shading.alphaTest, rows) & group.lanes;
  }
  Attributes attributes;
  loadAttributes(s, group, attributes);
  if (!shading.twoSided || !shading.lighting) back = 0;
  const bool frontSeen = (group.lanes & ~back) != 0;
  if (frontSeen) colorSide(frame, s, group, attributes, false, seen, rows);
  if (back) {
    LitRows backRows;
    colorSide(frame, s, group, attributes, true, seen, frontSeen ? backRows : rows);
    for (uint32_t lanes = frontSeen ? back : 0; lanes; lanes &= lanes - 1) {
      const int i = std::countr_zero(lanes);
      for (int c = 0; c < 7; ++c) rows.value[c][i] = backRows.value[c][i];
    }
  }
  if (!shading.textures.empty()) textureLanes(frame, s, group, x, y, rows);
  const bool fogged = shading.fog.mode != scene::Fog::off;
  if (shading.separateSpecular || shading.colorSum) addSecondary(!fogged || shading.fog.clampsSum, rows);
  if (fogged) applyFog(s, group, rows);
  return failingLanes(shading.alphaTest, rows) & group.lanes;
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
