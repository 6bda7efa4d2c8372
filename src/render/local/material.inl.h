// Materials of the lanes. Part of kernels.cpp (compiled once for each instruction set).
#if defined(GLURAY_RENDER_MATERIAL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_MATERIAL_INL_H_
#undef GLURAY_RENDER_MATERIAL_INL_H_
#else
#define GLURAY_RENDER_MATERIAL_INL_H_
#endif

#include "render/local/attributes.inl.h"
#include "render/local/light.inl.h"
#include "render/local/surface.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// Materials of a group: one for all lanes, or rows.
struct MaterialChoice {
  const scene::Material* uniform = nullptr;
  alignas(64) Row rows[kRows];
};

inline const scene::Material& faceOf(const scene::MaterialPair& pair, bool back) {
  return back ? pair.back : pair.front;
}

inline uint32_t materialIndex(const Surface& s, uint32_t vertex) {
  const scene::Attribute& a = s.mesh->materials;
  if (!a) return 0;
  const auto index = *reinterpret_cast<const uint32_t*>(a.data + static_cast<size_t>(vertex) * a.stride);
  return index < s.materialCount ? index : 0;
}

HWY_ATTR inline void fillLane(const scene::Material& m, int i, Row* rows) {
  for (int c = 0; c < 3; ++c) {
    rows[kEmission + c][i] = m.emission[c];
    rows[kAmbient + c][i] = m.ambient[c];
    rows[kDiffuse + c][i] = m.diffuse[c];
    rows[kSpecular + c][i] = m.specular[c];
  }
  rows[kAlpha][i] = m.diffuse.a;
  rows[kShininess][i] = m.shininess;
}

HWY_ATTR inline void copyRows(const Row* from, int count, Row* to) {
  for (int c = 0; c < count; ++c) {
    for (int i = 0; i < kLanes; ++i) to[c][i] = from[c][i];
  }
}

// glColorMaterial: sets the tracked components' rows to the vertex colour (four rows).
HWY_ATTR inline void followColor(scene::ColorMaterial::Mode mode, const Row* color, Row* rows) {
  using Mode = scene::ColorMaterial;
  if (mode == Mode::emission) copyRows(color, 3, rows + kEmission);
  if (mode == Mode::ambient || mode == Mode::ambientAndDiffuse) copyRows(color, 3, rows + kAmbient);
  if (mode == Mode::diffuse || mode == Mode::ambientAndDiffuse) copyRows(color, 4, rows + kDiffuse);
  if (mode == Mode::specular) copyRows(color, 3, rows + kSpecular);
}

/// The material of corner `k` of the group's triangles. `color`: vertex colours, read only if the mesh has
/// them.
HWY_ATTR inline void chooseMaterial(const Surface& s, const Group& group, int k, bool back, const Row* color,
                                    MaterialChoice& out) {
  const scene::ColorMaterial& tracking = s.lighting->shading->colorMaterial;
  const auto mode = s.colorsVary ? (back ? tracking.back : tracking.front) : scene::ColorMaterial::off;
  const uint32_t first = materialIndex(s, group.vertex[k][0]);
  bool uniform = true;
  for (int i = 1; i < kLanes && s.mesh->materials; ++i)
    uniform &= materialIndex(s, group.vertex[k][i]) == first;
  out.uniform = uniform && mode == scene::ColorMaterial::off ? &faceOf(s.materials[first], back) : nullptr;
  if (out.uniform) return;
  for (int i = 0; i < kLanes; ++i) {
    fillLane(faceOf(s.materials[uniform ? first : materialIndex(s, group.vertex[k][i])], back), i, out.rows);
  }
  followColor(mode, color, out.rows);
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
