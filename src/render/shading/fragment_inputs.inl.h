// Inputs of fragment programs at each hit: normals, base colours, distances to edges. Part of kernels.cpp
// (compiled once for each instruction set).
#if defined(GLURAY_RENDER_FRAGMENT_INPUTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_FRAGMENT_INPUTS_INL_H_
#undef GLURAY_RENDER_FRAGMENT_INPUTS_INL_H_
#else
#define GLURAY_RENDER_FRAGMENT_INPUTS_INL_H_
#endif

#include "render/edges/edged_triangle.h"
#include "render/frame_data/frame_data.h"
#include "render/local/fragment.inl.h"
#include "render/local/textured_triangle.h"

#include <algorithm>
#include <bit>

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

/// The mask of the vector that begins at lane i, from bits.
HWY_INLINE hn::Mask<FloatTag> lanesAt(uint32_t lanes, int i) {
  uint8_t bits[8] = {static_cast<uint8_t>(lanes >> i), static_cast<uint8_t>(lanes >> i >> 8)};
  return hn::LoadMaskBits(FloatTag(), bits);
}

/// Inputs of a fragment program, for one vector of lanes.
struct Fragment {
  Float3 position;  // the program's eye space
  Float3 toViewer;  // unit length
  Float3 normal;    // unit length, on the lit side
  Float3 color;     // factor of the material's colours
  Float edge;       // weight of the edge colour, 0 .. 1; only if edges are painted
  Float front;      // 0 on back faces that no light shines on, otherwise 1
};

HWY_ATTR inline void clampRows(Row (&corner)[3][4]) {
  for (auto& rows : corner)
    for (Row& row : rows)
      for (int i = 0; i < kLanes; i += lanesOfVector()) store(clamp01(load(row + i)), row + i);
}

HWY_ATTR inline void loadHeightColors(const scene::HeightColors& of, const Group& group, Row (&out)[4]) {
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const auto at = [&](int k) HWY_ATTR { return load(group.position[k][of.axis] + i); };
    const Float height = Weights(group, i)(at(0), at(1), at(2));
    for (int c = 0; c < 3; ++c) {
      Float v = clamp01(hn::Mul(splat(of.scale[c]), hn::Add(height, splat(of.offset[c]))));
      if (of.exponent[c] != 1) v = power(v, splat(of.exponent[c]));
      store(v, out[c] + i);
    }
  }
}

/// Each component to a power; what is below 0 becomes 0.
HWY_INLINE Float3 raised(const Float3& v, float exponent) {
  const Float zero = splat(0), to = splat(exponent);
  return {power(hn::Max(v.x, zero), to), power(hn::Max(v.y, zero), to), power(hn::Max(v.z, zero), to)};
}

/// Red, green and blue to a power.
HWY_ATTR inline void raise(float exponent, Row (&color)[4]) {
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const Float3 v = raised(load3(color, i), exponent);
    store(v.x, color[0] + i), store(v.y, color[1] + i), store(v.z, color[2] + i);
  }
}

/// Colour and alpha of the lanes from a texture, the vertices or an array per triangle; ones if only the
/// material has a colour.
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
  } else if (f.color == Color::height) {
    loadHeightColors(f.height, group, out);
  } else if (f.color == Color::vertices && !s.colorsVary) {
    const glm::vec4& color = s.instance->color;
    fillRows<4>(f.clampsColors ? glm::clamp(color, 0.0f, 1.0f) : color, out);
  } else if (f.color == Color::vertices) {
    alignas(64) Row corner[3][4];
    for (int k = 0; k < 3; ++k) loadVec4(s.mesh->colors, group.vertex[k], corner[k]);
    if (f.clampsColors) clampRows(corner);
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

/// The first two components of texture coordinates.
HWY_ATTR inline void loadVec2(const scene::Attribute& a, const uint32_t* vertex, Row* out) {
  if (a.format == scene::Format::float1 || a.format == scene::Format::unorm8x4) {
    for (int i = 0; i < kLanes; ++i) {
      const glm::vec4 v = scene::fetch(a, vertex[i]);
      out[0][i] = v.x, out[1][i] = v.y;
    }
    return;
  }
  for (int i = 0; i < kLanes; ++i) {
    const auto* f = reinterpret_cast<const float*>(a.data + static_cast<size_t>(vertex[i]) * a.stride);
    out[0][i] = f[0], out[1][i] = f[1];
  }
}

/// Nearest texels at image positions, which lie in [0, width] x [0, height].
HWY_ATTR inline void nearestTexels(const scene::TextureImage& image, const float* x, const float* y,
                                   Row (&out)[4]) {
  const hn::Rebind<int32_t, FloatTag> di;
  const auto lastColumn = hn::Set(di, image.width - 1), lastRow = hn::Set(di, image.height - 1),
             width = hn::Set(di, image.width), byteMask = hn::Set(di, 255);
  const auto* texels = reinterpret_cast<const int32_t*>(image.texels.data());
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const auto column = hn::Min(hn::ConvertTo(di, load(x + i)), lastColumn);
    const auto row = hn::Min(hn::ConvertTo(di, load(y + i)), lastRow);
    const auto texel = hn::GatherIndex(di, texels, hn::Add(hn::Mul(row, width), column));
    const auto channel = [&](auto bits) HWY_ATTR {
      return hn::Mul(hn::ConvertTo(FloatTag(), hn::And(bits, byteMask)), splat(1.0f / 255.0f));
    };
    store(channel(texel), out[0] + i);
    store(channel(hn::ShiftRight<8>(texel)), out[1] + i);
    store(channel(hn::ShiftRight<16>(texel)), out[2] + i);
    store(channel(hn::ShiftRight<24>(texel)), out[3] + i);
  }
}

/// The nearest texel at an image position, or the linear mix of the four around it.
inline glm::vec4 texelAt(const scene::TextureImage& image, scene::Filter filter, float x, float y) {
  const auto texel = [&](int column, int row) {
    const size_t i =
        static_cast<size_t>(std::clamp(row, 0, image.height - 1)) * static_cast<size_t>(image.width) +
        static_cast<size_t>(std::clamp(column, 0, image.width - 1));
    return image.texels.empty() ? image.floats[i] : unpack(image.texels[i]);
  };
  if (filter == scene::Filter::nearest) return texel(static_cast<int>(x), static_cast<int>(y));
  const float fx = std::floor(x - 0.5f), fy = std::floor(y - 0.5f), wx = x - 0.5f - fx, wy = y - 0.5f - fy;
  const int x0 = static_cast<int>(fx), y0 = static_cast<int>(fy);
  return glm::mix(glm::mix(texel(x0, y0), texel(x0 + 1, y0), wx),
                  glm::mix(texel(x0, y0 + 1), texel(x0 + 1, y0 + 1), wx), wy);
}

/// Transforms (s, t) of a corner by the matrix, without division.
HWY_ATTR inline void moveTexcoords(const glm::mat4& m, Row (&corner)[2]) {
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const Float s = load(corner[0] + i), t = load(corner[1] + i);
    for (int c = 0; c < 2; ++c)
      store(hn::MulAdd(splat(m[0][c]), s, hn::MulAdd(splat(m[1][c]), t, splat(m[3][c]))), corner[c] + i);
  }
}

/// Samples the colour map: clamped to the edge, one level, nearest or linear.
HWY_ATTR inline void lookUpMap(const Surface& s, const Group& group, Row (&out)[4]) {
  const scene::Texture& map = s.lighting->shading->fragment.map.front();
  const scene::TextureImage& image = *map.image;
  alignas(64) Row at[2];
  alignas(64) Row corner[3][2];
  for (int k = 0; k < 3; ++k) {
    if (s.mesh->texcoords)
      loadVec2(s.mesh->texcoords, group.vertex[k], corner[k]);
    else
      fillRows<2>(s.instance->texcoord, corner[k]);
    if (map.textureMatrix != glm::mat4(1)) moveTexcoords(map.textureMatrix, corner[k]);
  }
  const Float size[2] = {splat(static_cast<float>(image.width)), splat(static_cast<float>(image.height))};
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const Weights weights(group, i);
    for (int c = 0; c < 2; ++c) {
      const Float t =
          hn::Mul(weights(load(corner[0][c] + i), load(corner[1][c] + i), load(corner[2][c] + i)), size[c]);
      // A comparison fails for NaN, which leaves 0.
      store(hn::IfThenElseZero(hn::Gt(t, splat(0)), hn::Min(t, size[c])), at[c] + i);
    }
  }
  if (map.magFilter == scene::Filter::nearest && !image.texels.empty())
    return nearestTexels(image, at[0], at[1], out);
  for (int i = 0; i < kLanes; ++i) {
    const glm::vec4 color = texelAt(image, map.magFilter, at[0][i], at[1][i]);
    for (int k = 0; k < 4; ++k) out[k][i] = color[k];
  }
}

HWY_INLINE Float3 pointIn(const Surface& s, const Group& group, int k, int i) {
  return transformPoint(s.instance->lightingFromObject, load3(group.position[k], i));
}

/// Normals from the vertices or from an array per triangle, object space.
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

/// Whether the vertex shader makes normals unit length.
inline bool hasUnitVertices(const scene::FragmentShading& f) {
  using Unit = scene::FragmentShading::UnitNormals;
  return f.unitNormals != Unit::never && !(f.unitNormals == Unit::pixels && f.facesViewer);
}

/// Vertex normals that the vertex shader transforms, and makes unit length or turns to the viewer,
/// interpolated.
HWY_ATTR inline void loadEyeNormals(const Surface& s, const Group& group, Row (&out)[3]) {
  const scene::FragmentShading& f = s.lighting->shading->fragment;
  const bool units = hasUnitVertices(f);
  const glm::mat3& matrix = s.instance->normalMatrix;
  if (const glm::vec3 n = matrix * s.instance->normal; !s.mesh->normals && !f.facesViewer)
    return fillRows<3>(units ? glm::normalize(n) : n, out);
  alignas(64) Row corner[3][3];
  for (int k = 0; k < 3; ++k) {
    if (s.mesh->normals)
      loadVec3(s.mesh->normals, s.mesh->vertexCount, group.vertex[k], corner[k]);
    else
      fillRows<3>(s.instance->normal, corner[k]);
  }
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const Weights weights(group, i);
    const auto at = [&](int k) HWY_ATTR {
      Float3 n = transform(matrix, load3(corner[k], i));
      if (units) n = unit(n);
      return f.facesViewer ? signedBy(hn::Le(dot(n, pointIn(s, group, k, i)), splat(0)), n) : n;
    };
    const Float3 n = weights(at(0), at(1), at(2));
    store(n.x, out[0] + i), store(n.y, out[1] + i), store(n.z, out[2] + i);
  }
}

/// The geometric normal of the triangle, towards the viewer.
HWY_INLINE Float3 triangleNormal(const Surface& s, const Group& group, int i, const Float3& p) {
  const Float3 a = pointIn(s, group, 0, i);
  const Float3 n = unit(cross(sub(pointIn(s, group, 1, i), a), sub(pointIn(s, group, 2, i), a)));
  if (s.lighting->shading->fragment.parallelView) return signedBy(hn::Ge(n.z, splat(0)), n);
  return signedBy(hn::Le(dot(n, p), splat(0)), n);
}

/// Multiplies colour and alpha of a fragment program, the first four of `rows`, or without alpha the first
/// three, by its textures. They are evaluated as factors, so that colours above 1 are not clamped before the
/// product.
HWY_ATTR inline void multiplyByTextures(const FrameData& frame, const Surface& s, const Group& group,
                                        uint32_t lanes, const float* x, const float* y, Row* rows,
                                        int channels = 4) {
  TexturedTriangle triangle(s, frame.snapshot->camera);
  for (; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    const glm::vec4 factor = triangle.color(group.primitive[i], group.u[i], group.v[i], {x[i], y[i]},
                                            glm::vec4(1), group.steps ? group.steps + i : nullptr);
    for (int c = 0; c < channels; ++c) rows[c][i] *= factor[c];
  }
}

/// Weights of the edge colour at window positions x, y.
HWY_ATTR inline void edgeShares(const FrameData& frame, const Surface& s, const Group& group, const float* x,
                                const float* y, Row& out) {
  for (int i = 0; i < kLanes; ++i)
    out[i] = EdgedTriangle(s, frame.snapshot->camera, group.primitive[i]).edgeShare({x[i], y[i]});
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
