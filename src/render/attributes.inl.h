// Vertex data of the hit triangles, brought into lanes. Part of kernels.cpp (compiled once for each
// instruction set).
#if defined(GLURAY_RENDER_ATTRIBUTES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_ATTRIBUTES_INL_H_
#undef GLURAY_RENDER_ATTRIBUTES_INL_H_
#else
#define GLURAY_RENDER_ATTRIBUTES_INL_H_
#endif

#include "accel/ray_packet.h"
#include "scene/mesh.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

using accel::kLanes;

/// One float for each lane; row[c] of several is component c.
using Row = float[kLanes];

/// The lanes of a packet that hit one instance. Lanes outside the group repeat a lane of it, so that every
/// load is valid.
struct Group {
  uint32_t lanes = 0;  // bit i: lane i belongs to the group
  alignas(64) uint32_t primitive[kLanes];
  alignas(64) uint32_t vertex[3][kLanes];
  alignas(64) Row position[3][3];  // [corner][component], object space
  alignas(64) Row u, v;
};

HWY_ATTR inline void loadVec3(const scene::Attribute& a, const uint32_t* vertex, Row* out) {
  for (int i = 0; i < kLanes; ++i) {
    const auto* f = reinterpret_cast<const float*>(a.data + static_cast<size_t>(vertex[i]) * a.stride);
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

/// Vertices and positions of the group's triangles; `lanes`, `primitive`, `u` and `v` are there already.
HWY_ATTR inline void loadCorners(const scene::Mesh& mesh, Group& group) {
  if (mesh.indices) {
    const auto* indices = reinterpret_cast<const uint32_t*>(mesh.indices.data);
    for (int i = 0; i < kLanes; ++i) {
      const uint32_t* corner = indices + static_cast<size_t>(group.primitive[i]) * 3;
      for (int k = 0; k < 3; ++k) group.vertex[k][i] = corner[k];
    }
  } else {
    for (uint32_t k = 0; k < 3; ++k) {
      for (int i = 0; i < kLanes; ++i) group.vertex[k][i] = group.primitive[i] * 3 + k;
    }
  }
  for (int k = 0; k < 3; ++k) loadVec3(mesh.positions, group.vertex[k], group.position[k]);
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
