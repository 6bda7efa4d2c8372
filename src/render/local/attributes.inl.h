// Gathers vertex data of the hit triangles into lanes. Part of kernels.cpp (compiled once for each
// instruction set).
#if defined(GLURAY_RENDER_ATTRIBUTES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_ATTRIBUTES_INL_H_
#undef GLURAY_RENDER_ATTRIBUTES_INL_H_
#else
#define GLURAY_RENDER_ATTRIBUTES_INL_H_
#endif

#include "render/local/group.h"
#include "scene/mesh.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET != HWY_SCALAR
// Transposes four vectors, each read as four floats, into rows x, y, z.
HWY_INLINE void loadFour(const float* a, const float* b, const float* c, const float* d, int i, Row* out) {
  const hn::FixedTag<float, 4> tag;
  const auto va = hn::LoadU(tag, a), vb = hn::LoadU(tag, b), vc = hn::LoadU(tag, c), vd = hn::LoadU(tag, d);
  const auto ac = hn::InterleaveLower(tag, va, vc), bd = hn::InterleaveLower(tag, vb, vd);
  hn::Store(hn::InterleaveLower(tag, ac, bd), tag, out[0] + i);
  hn::Store(hn::InterleaveUpper(tag, ac, bd), tag, out[1] + i);
  hn::Store(hn::InterleaveLower(tag, hn::InterleaveUpper(tag, va, vc), hn::InterleaveUpper(tag, vb, vd)), tag,
            out[2] + i);
}
#endif

/// Gathers three-component elements into rows x, y, z. `count`: number of elements.
HWY_ATTR inline void loadVec3(const scene::Attribute& a, uint32_t count, const uint32_t* vertex, Row* out) {
  const auto at = [&](int i) HWY_ATTR {
    return reinterpret_cast<const float*>(a.data + static_cast<size_t>(vertex[i]) * a.stride);
  };
#if HWY_TARGET != HWY_SCALAR
  // Reading a fourth float is safe except at the last element.
  bool atEnd = false;
  for (int i = 0; i < kLanes; ++i) atEnd |= vertex[i] + 1 >= count;
  if (!atEnd) {
    for (int i = 0; i < kLanes; i += 4) loadFour(at(i), at(i + 1), at(i + 2), at(i + 3), i, out);
    return;
  }
#endif
  (void)count;
  for (int i = 0; i < kLanes; ++i) {
    const float* f = at(i);
    out[0][i] = f[0], out[1][i] = f[1], out[2][i] = f[2];
  }
}

HWY_ATTR inline void loadVec4(const scene::Attribute& a, const uint32_t* vertex, Row* out) {
  for (int i = 0; i < kLanes; ++i) {
    const glm::vec4 v = scene::fetch(a, vertex[i]);
    out[0][i] = v.x, out[1][i] = v.y, out[2][i] = v.z, out[3][i] = v.w;
  }
}

template <int components, class Value>
HWY_ATTR void fillRows(const Value& value, Row* out) {
  for (int c = 0; c < components; ++c) {
    for (int i = 0; i < kLanes; ++i) out[c][i] = value[c];
  }
}

HWY_INLINE void loadTriangle(const scene::Mesh& mesh, uint32_t primitive, uint32_t (&vertex)[3]) {
  for (uint32_t k = 0; k < 3; ++k) vertex[k] = mesh.corner(primitive, k);
}

/// Loads the positions of the group's triangles; group.vertex must be set.
HWY_ATTR inline void loadCorners(const scene::Mesh& mesh, Group& group) {
  for (int k = 0; k < 3; ++k) loadVec3(mesh.positions, mesh.vertexCount, group.vertex[k], group.position[k]);
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
