// Vertices as a program sent them: interleaved floats, primitives, material changes between vertices. Filled
// by VertexStream (glBegin, lists) and gl/arrays; mesh_builder turns them into meshes, replay into GL calls.
#pragma once
#include "base/hash.h"
#include "gl/basics/growing_array.h"
#include "gl/capture/attribute_slots.h"
#include "gl/capture/surface_facts.h"
#include "scene/shading.h"

#include <GL/gl.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace gluray::gl {

/// Which slots a captured vertex has, and where. The position is always at 0.
struct VertexLayout {
  SlotMask mask = bit(kPosition);
  uint8_t offset[kSlotCount] = {};  // floats from the vertex's start; 0 = absent (except the position)
  uint8_t stride = 3;               // floats

  bool has(Slot slot) const { return mask & bit(slot); }
  static VertexLayout layoutOf(SlotMask mask);
};

struct Primitive {
  GLenum mode;
  uint32_t first, count;  // in indices if the capture has any, else in vertices
  bool operator==(const Primitive&) const = default;
};

/// Class of a primitive. Lines and points are traced if settings or a program turn them into solids.
enum class PrimitiveClass : uint8_t { points, lines, surfaces };
constexpr PrimitiveClass classOf(GLenum mode) {
  return mode == GL_POINTS       ? PrimitiveClass::points
         : mode <= GL_LINE_STRIP ? PrimitiveClass::lines
                                 : PrimitiveClass::surfaces;
}

/// Accumulated glMaterial calls since the start of a capture: which parameters were set, and their values.
struct MaterialChange {
  enum Parameter : uint16_t { ambient = 1, diffuse = 2, specular = 4, emission = 8, shininess = 16 };
  uint16_t front = 0, back = 0;  // Parameters that were set
  bool outside = false;          // the last call was made in a list, outside glBegin and glEnd
  scene::MaterialPair values;
  bool operator==(const MaterialChange&) const = default;
  /// Sets `pname` of `face`. False if glMaterial does not take these enumerants.
  bool set(GLenum face, GLenum pname, const float* params);
  /// The parameters that this change, made from `earlier`, sets anew or to other values.
  MaterialChange since(const MaterialChange& earlier) const;
  /// `base` with the set parameters replaced.
  scene::MaterialPair appliedTo(const scene::MaterialPair& base) const;
};

/// Bits of MaterialChange::Parameter that have equal values in both materials.
uint16_t sameParameters(const scene::Material& a, const scene::Material& b);

/// Bits of MaterialChange::Parameter that follow the colour in this mode.
uint16_t parametersOf(scene::ColorMaterial::Mode mode);

/// `base` with the parameters that follow the colour replaced by `color`, four components.
scene::MaterialPair materialOfColor(const scene::MaterialPair& base, const scene::ColorMaterial& following,
                                    const float* color);

struct CapturedVertices {
  VertexLayout layout;
  GrowingArray<float> vertices;  // `vertexCount` of `layout.stride`; the array's own size is not used
  uint32_t vertexCount = 0;
  std::vector<Primitive> primitives;
  GrowingArray<uint32_t> indices;         // vertex numbers; if empty, primitives count vertices
  std::vector<MaterialChange> materials;  // entry i is material number i+1; 0 is the material of the call
  std::optional<SurfaceFacts> facts;      // about the triangles, if they were computed during capture

  bool empty() const { return primitives.empty(); }
  const float* vertex(uint32_t i) const { return vertices.data() + size_t{i} * layout.stride; }
  float* vertex(uint32_t i) { return vertices.data() + size_t{i} * layout.stride; }
  size_t sizeBytes() const {
    return size_t{vertexCount} * layout.stride * sizeof(float) + indices.size() * 4;
  }
  /// Content hash of layout, vertices, primitives and indices; vertices hold the numbers of materials.
  Hash128 hash() const;
  void clear();
};

/// A slot that a list's run first sets after `vertices` vertices: these vertices take the caller's current
/// value.
struct InheritedSlot {
  Slot slot;
  uint32_t vertices;
};

/// The triangles of `captured`: three vertex numbers each, the provoking vertex last. Polygons and quads are
/// split as in Mesa.
std::vector<uint32_t> triangulate(const CapturedVertices& captured);

/// The points or line segments of `captured`: one or two vertex numbers for each.
std::vector<uint32_t> solidCorners(const CapturedVertices& captured);

/// Number of triangles in a primitive of `count` vertices; 0 for lines, points and patches.
uint64_t countTriangles(GLenum mode, uint64_t count);

/// Number of triangles in all surfaces of `captured`.
uint64_t countTriangles(const CapturedVertices& captured);

}  // namespace gluray::gl
