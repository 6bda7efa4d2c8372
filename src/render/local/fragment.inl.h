// Rows of colours, and the fragment operations after texturing: fog and alpha test. Part of kernels.cpp
// (compiled once for each instruction set).
#if defined(GLURAY_RENDER_FRAGMENT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_FRAGMENT_INL_H_
#undef GLURAY_RENDER_FRAGMENT_INL_H_
#else
#define GLURAY_RENDER_FRAGMENT_INL_H_
#endif

#include "render/local/alpha_test.h"
#include "render/local/attributes.inl.h"
#include "render/local/light.inl.h"
#include "render/local/surface.h"

#include <hwy/contrib/math/math-inl.h>

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

HWY_INLINE Float load(const float* p) { return hn::Load(FloatTag(), p); }
HWY_INLINE void store(Float v, float* p) { hn::Store(v, FloatTag(), p); }
HWY_INLINE Float3 load3(const Row* rows, int i) {
  return {load(rows[0] + i), load(rows[1] + i), load(rows[2] + i)};
}
HWY_INLINE int lanesOfVector() { return static_cast<int>(hn::Lanes(FloatTag())); }

/// Lit colours of a packet.
struct LitRows : ColorRows {
  HWY_INLINE void set(int i, const Lit& lit) {
    store(lit.primary.x, value[0] + i), store(lit.primary.y, value[1] + i),
        store(lit.primary.z, value[2] + i);
    store(lit.alpha, value[3] + i);
    store(lit.secondary.x, value[4] + i), store(lit.secondary.y, value[5] + i),
        store(lit.secondary.z, value[6] + i);
  }
};

/// Weights of the three corners in each lane.
struct Weights {
  Float w0, w1, w2;
  HWY_INLINE Weights(const Group& g, int i) : w0(load(g.u + i)), w1(load(g.u + i)), w2(load(g.v + i)) {
    w0 = hn::Sub(hn::Sub(splat(1), w1), w2);
  }
  /// Moves points that lie beside the triangle onto its edges.
  HWY_INLINE void clampToTriangle() {
    w1 = hn::Max(w1, hn::Zero(FloatTag())), w2 = hn::Max(w2, hn::Zero(FloatTag()));
    const Float most = hn::Max(hn::Add(w1, w2), splat(1));
    w1 = hn::Div(w1, most), w2 = hn::Div(w2, most);
    w0 = hn::Sub(hn::Sub(splat(1), w1), w2);
  }
  HWY_INLINE Float operator()(Float a, Float b, Float c) const {
    return hn::MulAdd(a, w0, hn::MulAdd(b, w1, hn::Mul(c, w2)));
  }
  HWY_INLINE Float3 operator()(const Float3& a, const Float3& b, const Float3& c) const {
    return {(*this)(a.x, b.x, c.x), (*this)(a.y, b.y, c.y), (*this)(a.z, b.z, c.z)};
  }
};

HWY_INLINE Float3 transform(const glm::mat3& m, const Float3& v) {
  return {hn::MulAdd(splat(m[0].x), v.x, hn::MulAdd(splat(m[1].x), v.y, hn::Mul(splat(m[2].x), v.z))),
          hn::MulAdd(splat(m[0].y), v.x, hn::MulAdd(splat(m[1].y), v.y, hn::Mul(splat(m[2].y), v.z))),
          hn::MulAdd(splat(m[0].z), v.x, hn::MulAdd(splat(m[1].z), v.y, hn::Mul(splat(m[2].z), v.z)))};
}

HWY_INLINE Float3 transformPoint(const glm::mat4& m, const Float3& p) {
  return add(transform(glm::mat3(m), p), splat(glm::vec3(m[3])));
}

// Fog factor at a distance, GL 2.1, 3.10: the weight of the fragment's colour.
HWY_INLINE Float fogFactor(const scene::Fog& fog, Float distance) {
  const FloatTag d;
  if (fog.mode == scene::Fog::linear) {
    const float scale = fog.scaled ? fog.scale : 1 / (fog.end - fog.start);
    const Float factor = hn::Mul(hn::Sub(splat(fog.end), distance), splat(scale));
    return fog.extrapolates ? hn::Min(factor, splat(1)) : clamp01(factor);
  }
  Float thickness = hn::Mul(distance, splat(fog.density));
  if (fog.mode == scene::Fog::exp2) thickness = hn::Mul(thickness, thickness);
  return clamp01(hn::Exp(d, hn::Neg(thickness)));
}

// Fog coordinates of the corners of the group's triangles.
HWY_ATTR inline void loadFogCoords(const Surface& s, const Group& group, Row (&out)[3]) {
  const scene::Attribute& a = s.mesh->fogCoords;
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < kLanes; ++i)
      out[k][i] = a ? scene::fetch(a, group.vertex[k][i]).x : s.instance->fogCoord;
}

// Applies the surface's fog to colours; alpha is unchanged.
HWY_ATTR inline void applyFog(const Surface& s, const Group& group, LitRows& rows) {
  const scene::Fog& fog = s.lighting->shading->fog;
  const bool program = scene::isProgram(*s.lighting->shading);
  const glm::mat4& eye = program ? s.instance->lightingFromObject : s.eyeFromObject;
  const glm::vec4 eyeZ(eye[0].z, eye[1].z, eye[2].z, eye[3].z);
  const bool impostors = program ? s.mesh->shape != scene::Shape::triangles : scene::isSolid(s.mesh->shape);
  alignas(64) Row coordinates[3];
  if (fog.fromCoordinates) loadFogCoords(s, group, coordinates);
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const Weights weights(group, i);
    const Float3 p =
        weights(load3(group.position[0], i), load3(group.position[1], i), load3(group.position[2], i));
    const Float z = hn::MulAdd(p.x, splat(eyeZ.x),
                               hn::MulAdd(p.y, splat(eyeZ.y), hn::MulAdd(p.z, splat(eyeZ.z), splat(eyeZ.w))));
    const Float seen = impostors ? load(group.point[2] + i) : z;
    Float distance = program ? hn::Neg(seen) : hn::Abs(seen);
    if (fog.fromCoordinates)
      distance = weights(load(coordinates[0] + i), load(coordinates[1] + i), load(coordinates[2] + i));
    const Float factor = fogFactor(fog, distance);
    for (int c = 0; c < 3; ++c) {
      const Float color = load(rows.value[c] + i), background = splat(fog.color[c]);
      const Float kept = fog.clampsSum && !program ? clamp01(color) : color;
      const Float mixed = hn::MulAdd(factor, hn::Sub(kept, background), background);
      store(program ? mixed : clamp01(mixed), rows.value[c] + i);
    }
  }
}

// Lanes whose alpha fails the comparison.
HWY_ATTR inline uint32_t failingLanes(const scene::AlphaTest& test, const LitRows& rows) {
  if (test.function == scene::AlphaTest::always) return 0;
  uint32_t failing = 0;
  for (int i = 0; i < kLanes; ++i) failing |= static_cast<uint32_t>(!passes(test, rows.value[3][i])) << i;
  return failing;
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
