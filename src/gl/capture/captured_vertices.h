// Vertices as a program sent them: interleaved floats, primitives, changes of material between vertices.
// Filled by VertexStream (glBegin, lists) and by arrays.cpp; turned into meshes by mesh_builder and back into
// GL calls by replay.
#pragma once
#include "base/hash.h"
#include "gl/capture/attribute_slots.h"
#include "gl/capture/growing_array.h"
#include "scene/shading.h"

#include <GL/gl.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gluray::gl {

/// Which slots a captured vertex has, and where. The position is always at 0.
struct VertexLayout {
  SlotMask mask = bit(kPosition);
  uint8_t offset[kSlotCount] = {};  // floats from the vertex's start; 0 = absent (except the position)
  uint8_t stride = 3;               // floats

  bool has(Slot slot) const { return mask & bit(slot); }
  static VertexLayout of(SlotMask mask);
};

struct Primitive {
  GLenum mode;
  uint32_t first, count;  // vertices, or indices where the capture has any
  bool operator==(const Primitive&) const = default;
};

/// What a primitive fills: surfaces may be traced, lines and points never are.
enum class PrimitiveClass : uint8_t { points, lines, surfaces };
constexpr PrimitiveClass classOf(GLenum mode) {
  return mode == GL_POINTS       ? PrimitiveClass::points
         : mode <= GL_LINE_STRIP ? PrimitiveClass::lines
                                 : PrimitiveClass::surfaces;
}

/// Calls of glMaterial since the start of a capture, accumulated: which parameters were set and to what.
struct MaterialChange {
  enum Parameter : uint16_t { ambient = 1, diffuse = 2, specular = 4, emission = 8, shininess = 16 };
  uint16_t front = 0, back = 0;  // Parameters that were set
  bool outside = false;          // the last of the calls was made in a list, outside glBegin and glEnd
  scene::MaterialPair values;
  bool operator==(const MaterialChange&) const = default;
  /// Sets `pname` of `face`; false where they are not enumerants that glMaterial takes.
  bool set(GLenum face, GLenum pname, const float* params);
  /// What it sets that `earlier`, which it was made from, did not set or set to other values.
  MaterialChange since(const MaterialChange& earlier) const;
  /// `base` with the changes made.
  scene::MaterialPair appliedTo(const scene::MaterialPair& base) const;
};

/// Those of MaterialChange::Parameter that have the same value in both.
uint16_t sameParameters(const scene::Material& a, const scene::Material& b);

struct CapturedVertices {
  VertexLayout layout;
  GrowingArray<float> vertices;  // `vertexCount` of `layout.stride`; the array's own size is not used
  uint32_t vertexCount = 0;
  std::vector<Primitive> primitives;
  GrowingArray<uint32_t> indices;         // element numbers; empty: primitives count vertices
  std::vector<MaterialChange> materials;  // entry i is material number i+1; 0 is the material of the call

  bool empty() const { return primitives.empty(); }
  const float* vertex(uint32_t i) const { return vertices.data() + size_t{i} * layout.stride; }
  float* vertex(uint32_t i) { return vertices.data() + size_t{i} * layout.stride; }
  size_t sizeBytes() const {
    return size_t{vertexCount} * layout.stride * sizeof(float) + indices.size() * 4;
  }
  /// Identity of everything that the traced picture can depend on.
  Hash128 hash() const;
  void clear();
};

/// A slot that was first set after `vertices` vertices of a list had been captured: those take the caller's
/// current value.
struct InheritedSlot {
  Slot slot;
  uint32_t vertices;
};

/// Triangles that `captured` describes: three vertex numbers each, the provoking vertex last, split as Mesa
/// splits.
std::vector<uint32_t> triangulate(const CapturedVertices& captured);

/// Triangles that one primitive of `count` vertices makes; none for lines, points and patches.
uint64_t countTriangles(GLenum mode, uint64_t count);

/// Triangles in all surfaces of `captured`.
uint64_t countTriangles(const CapturedVertices& captured);

}  // namespace gluray::gl
