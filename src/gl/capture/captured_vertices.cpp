#include "gl/capture/captured_vertices.h"

#include "parallel/loops.h"

#include <GL/glext.h>
#include <glm/gtc/type_ptr.hpp>

#include <bit>

namespace gluray::gl {

VertexLayout VertexLayout::layoutOf(SlotMask mask) {
  VertexLayout layout;
  layout.mask = mask | bit(kPosition);
  layout.stride = 3;
  for (int s = kPosition + 1; s < kSlotCount; ++s) {
    const auto slot = static_cast<Slot>(s);
    if (!layout.has(slot)) continue;
    layout.offset[slot] = layout.stride;
    layout.stride = static_cast<uint8_t>(layout.stride + sizeOf(slot));
  }
  return layout;
}

namespace {

/// Sets one parameter of one material. False if glMaterial does not take `pname`.
bool setParameter(scene::Material& material, uint16_t& set, GLenum pname, const float* p) {
  const glm::vec4 color = pname == GL_SHININESS ? glm::vec4(0) : glm::vec4(p[0], p[1], p[2], p[3]);
  switch (pname) {
    case GL_AMBIENT: material.ambient = color, set |= MaterialChange::ambient; return true;
    case GL_DIFFUSE: material.diffuse = color, set |= MaterialChange::diffuse; return true;
    case GL_SPECULAR: material.specular = color, set |= MaterialChange::specular; return true;
    case GL_EMISSION: material.emission = color, set |= MaterialChange::emission; return true;
    case GL_SHININESS: material.shininess = p[0], set |= MaterialChange::shininess; return true;
    case GL_AMBIENT_AND_DIFFUSE:
      material.ambient = material.diffuse = color;
      set |= MaterialChange::ambient | MaterialChange::diffuse;
      return true;
    default: return false;
  }
}

void apply(scene::Material& base, const scene::Material& values, uint16_t set) {
  if (set & MaterialChange::ambient) base.ambient = values.ambient;
  if (set & MaterialChange::diffuse) base.diffuse = values.diffuse;
  if (set & MaterialChange::specular) base.specular = values.specular;
  if (set & MaterialChange::emission) base.emission = values.emission;
  if (set & MaterialChange::shininess) base.shininess = values.shininess;
}

}  // namespace

uint16_t sameParameters(const scene::Material& a, const scene::Material& b) {
  uint16_t same = 0;
  if (a.ambient == b.ambient) same |= MaterialChange::ambient;
  if (a.diffuse == b.diffuse) same |= MaterialChange::diffuse;
  if (a.specular == b.specular) same |= MaterialChange::specular;
  if (a.emission == b.emission) same |= MaterialChange::emission;
  if (a.shininess == b.shininess) same |= MaterialChange::shininess;
  return same;
}

uint16_t parametersOf(scene::ColorMaterial::Mode mode) {
  switch (mode) {
    case scene::ColorMaterial::off: return 0;
    case scene::ColorMaterial::emission: return MaterialChange::emission;
    case scene::ColorMaterial::ambient: return MaterialChange::ambient;
    case scene::ColorMaterial::diffuse: return MaterialChange::diffuse;
    case scene::ColorMaterial::specular: return MaterialChange::specular;
    case scene::ColorMaterial::ambientAndDiffuse: break;
  }
  return MaterialChange::ambient | MaterialChange::diffuse;
}

bool MaterialChange::set(GLenum face, GLenum pname, const float* params) {
  if (face != GL_FRONT && face != GL_BACK && face != GL_FRONT_AND_BACK) return false;
  bool known = true;
  if (face != GL_BACK) known = setParameter(values.front, front, pname, params);
  if (face != GL_FRONT) known = setParameter(values.back, back, pname, params);
  return known;
}

MaterialChange MaterialChange::since(const MaterialChange& earlier) const {
  MaterialChange result = *this;
  result.front &=
      static_cast<uint16_t>(~(earlier.front & sameParameters(values.front, earlier.values.front)));
  result.back &= static_cast<uint16_t>(~(earlier.back & sameParameters(values.back, earlier.values.back)));
  return result;
}

scene::MaterialPair MaterialChange::appliedTo(const scene::MaterialPair& base) const {
  scene::MaterialPair result = base;
  apply(result.front, values.front, front);
  apply(result.back, values.back, back);
  return result;
}

scene::MaterialPair materialOfColor(const scene::MaterialPair& base, const scene::ColorMaterial& following,
                                    const float* color) {
  scene::Material values;
  values.ambient = values.diffuse = values.specular = values.emission = glm::make_vec4(color);
  scene::MaterialPair result = base;
  apply(result.front, values, parametersOf(following.front));
  apply(result.back, values, parametersOf(following.back));
  return result;
}

Hash128 CapturedVertices::hash() const {
  Hash128 h = hashLarge(vertices.data(), size_t{vertexCount} * layout.stride * sizeof(float),
                        {layout.mask, vertexCount});
  h = hashBytes(primitives.data(), primitives.size() * sizeof(Primitive), h);
  return indices.empty() ? h : hashLarge(indices.data(), indices.size() * sizeof(uint32_t), h);
}

void CapturedVertices::clear() {
  layout = {};
  vertexCount = 0;
  primitives.clear();
  indices.clear();
  materials.clear();
  facts.reset();
}

namespace {

/// Calls emit(a, b, c) for each triangle: vertex numbers within the primitive, the provoking vertex last.
template <class Emit>
void forEachTriangle(const Primitive& p, Emit&& emit) {
  const uint32_t n = p.count;
  switch (p.mode) {
    case GL_TRIANGLES:
      for (uint32_t i = 0; i + 2 < n; i += 3) emit(i, i + 1, i + 2);
      break;
    case GL_TRIANGLE_STRIP:
      for (uint32_t i = 0; i + 2 < n; ++i) i % 2 ? emit(i + 1, i, i + 2) : emit(i, i + 1, i + 2);
      break;
    case GL_TRIANGLE_FAN:
      for (uint32_t i = 1; i + 1 < n; ++i) emit(0, i, i + 1);
      break;
    case GL_POLYGON:  // the first vertex is the provoking one
      for (uint32_t i = 1; i + 1 < n; ++i) emit(i, i + 1, 0);
      break;
    case GL_QUADS:
      // Split as llvmpipe splits quads that have indices, are in lists, or are clipped by the view volume or
      // a clip plane. It splits all others along the diagonal from the first corner to the third (seen in
      // 22.3). A mesh that outlives the camera cannot do both.
      for (uint32_t i = 0; i + 3 < n; i += 4) emit(i, i + 1, i + 3), emit(i + 1, i + 2, i + 3);
      break;
    case GL_QUAD_STRIP:  // quad i has the corners 2i, 2i+1, 2i+3, 2i+2; 2i+3 is the provoking one
      for (uint32_t i = 0; i + 3 < n; i += 2) emit(i, i + 1, i + 3), emit(i + 2, i, i + 3);
      break;
    default: break;
  }
}

}  // namespace

std::vector<uint32_t> triangulate(const CapturedVertices& captured) {
  std::vector<uint32_t> triangles;
  triangles.reserve(countTriangles(captured) * 3 + 4);  // meshes need readable bytes after the last index
  for (const Primitive& p : captured.primitives) {
    const auto vertexOf = [&](uint32_t i) {
      return captured.indices.empty() ? p.first + i : captured.indices[p.first + i];
    };
    forEachTriangle(p, [&](uint32_t a, uint32_t b, uint32_t c) {
      triangles.insert(triangles.end(), {vertexOf(a), vertexOf(b), vertexOf(c)});
    });
  }
  return triangles;
}

std::vector<uint32_t> solidCorners(const CapturedVertices& captured) {
  std::vector<uint32_t> corners;
  for (const Primitive& p : captured.primitives) {
    const auto vertexOf = [&](uint32_t i) {
      return captured.indices.empty() ? p.first + i : captured.indices[p.first + i];
    };
    const auto line = [&](uint32_t a, uint32_t b) {
      corners.push_back(vertexOf(a)), corners.push_back(vertexOf(b));
    };
    const uint32_t n = p.count;
    if (p.mode == GL_POINTS)
      for (uint32_t i = 0; i < n; ++i) corners.push_back(vertexOf(i));
    else if (p.mode == GL_LINES)
      for (uint32_t i = 0; i + 1 < n; i += 2) line(i, i + 1);
    else
      for (uint32_t i = 0; i + 1 < n; ++i) line(i, i + 1);
    if (p.mode == GL_LINE_LOOP && n > 1) line(n - 1, 0);
  }
  return corners;
}

uint64_t countTriangles(GLenum mode, uint64_t count) {
  switch (mode) {
    case GL_TRIANGLES: return count / 3;
    case GL_QUADS: return count / 4 * 2;
    case GL_QUAD_STRIP: return count < 4 ? 0 : (count / 2 - 1) * 2;
    case GL_TRIANGLE_STRIP:
    case GL_TRIANGLE_FAN:
    case GL_POLYGON: return count < 3 ? 0 : count - 2;
    case GL_TRIANGLES_ADJACENCY: return count / 6;
    case GL_TRIANGLE_STRIP_ADJACENCY: return count < 6 ? 0 : count / 2 - 2;
    default: return 0;
  }
}

uint64_t countTriangles(const CapturedVertices& captured) {
  uint64_t count = 0;
  for (const Primitive& p : captured.primitives) count += countTriangles(p.mode, p.count);
  return count;
}

}  // namespace gluray::gl
