// Geometry and vertex attributes, immutable once made. Built by gl/, read by accel/ and render/; shared
// between frames and threads without locks.
#pragma once
#include "base/hash.h"
#include "scene/residence.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace gluray::scene {

/// How one element of an attribute is stored.
enum class Format : uint8_t {
  none,  // attribute absent: every vertex has the instance's constant value
  float1,
  float2,
  float3,
  float4,
  unorm8x4,  // four bytes, 255 = 1.0 (colours)
  uint32,    // indices and material numbers
  bits8,     // a byte of flags
};

/// A strided array in memory that `owner` keeps alive. Element i starts at data + i*stride.
/// Position and index arrays are followed by at least 16 readable bytes, for Embree's wide loads.
struct Attribute {
  std::shared_ptr<const void> owner;
  const std::byte* data = nullptr;
  uint32_t stride = 0;  // bytes, a multiple of 4
  Format format = Format::none;
  explicit operator bool() const { return format != Format::none; }
  bool operator==(const Attribute&) const = default;
};

/// Element i of `a`; missing components come from (0, 0, 0, 1). `a` must not be absent.
inline glm::vec4 fetch(const Attribute& a, uint32_t i) {
  const std::byte* p = a.data + static_cast<size_t>(i) * a.stride;
  const auto* f = reinterpret_cast<const float*>(p);
  switch (a.format) {
    case Format::float1: return {f[0], 0, 0, 1};
    case Format::float2: return {f[0], f[1], 0, 1};
    case Format::float3: return {f[0], f[1], f[2], 1};
    case Format::float4: return {f[0], f[1], f[2], f[3]};
    case Format::unorm8x4: {
      const auto* b = reinterpret_cast<const uint8_t*>(p);
      return glm::vec4(b[0], b[1], b[2], b[3]) / 255.0f;  // as GL 2.1, table 2.9, divides
    }
    default: return {0, 0, 0, 1};
  }
}

/// Primitive type of a mesh. All but triangles are impostors (scene/impostors.h). Spheres, discs and
/// cylinders are round in the space of Instance::lightingFromObject and have one vertex, their centre. Beads
/// (one vertex) and tubes (a line between two) have a size in pixels. Splats (one vertex with a radius) are
/// ellipses in the window. Balls (one vertex) and capsules (the convex hull of balls about the ends of a
/// line) replace flat points and lines of programs: they are solid for all rays. Sticks (a line between two
/// vertices, with a radius) are cylinders around the line, round in the space of
/// Instance::lightingFromObject, whose ends are open, flat or round (StickEnd).
enum class Shape : uint8_t {
  triangles,
  spheres,
  discs,
  cylinders,
  beads,
  tubes,
  splats,
  balls,
  capsules,
  sticks
};

/// Vertices per primitive.
constexpr uint32_t cornersOf(Shape shape) {
  if (shape == Shape::triangles) return 3;
  return shape == Shape::tubes || shape == Shape::capsules || shape == Shape::sticks ? 2 : 1;
}
constexpr bool isSizedInPixels(Shape shape) { return shape == Shape::beads || shape == Shape::tubes; }
constexpr bool isSolid(Shape shape) { return shape == Shape::balls || shape == Shape::capsules; }
/// Whether coverage is computed in the window (accel/impostors/pixel_impostor.h).
constexpr bool isInWindow(Shape shape) { return isSizedInPixels(shape) || shape == Shape::splats; }

/// Bits of Mesh::ends.
enum StickEnd : uint32_t {
  kClosedEnd = 1,  // otherwise the end is open
  kRoundEnd = 2,   // closed by half a ball, where Impostors::roundEnds allows it; otherwise flat
  kTwoHalves = 4,  // of the first vertex: colours change in the middle, otherwise they are interpolated
};

/// Triangles in object space. Triangle t has the vertices corner(t, 0..2), in winding order; OpenGL's
/// provoking vertex (flat shading) is always the last one. Without `indices` it is a triangle soup: vertices
/// 3t, 3t+1, 3t+2. For other shapes "triangle" t is the impostor at vertex corner(t, 0); surplus corners
/// repeat its last vertex.
struct Mesh {
  Hash128 geometryId;  // hash of positions and triangle order: the key of the BLAS
  Shape shape = Shape::triangles;
  uint32_t triangleCount = 0;
  uint32_t vertexCount = 0;  // every index is below this
  Attribute positions;       // float3
  Attribute indices;         // uint32, cornersOf(shape) per primitive, tightly packed (stride 4), or absent
  Attribute radii;           // of impostors: float1; absent: all have `radius`
  Attribute axes;            // of cylinders: float3, of the cylinder's length
  Attribute ends;            // of sticks: uint32, bits of StickEnd
  float radius = 1;
  Attribute normals;                      // float3, not necessarily of unit length
  Attribute colors;                       // float4, float3 or unorm8x4
  Attribute texcoords;                    // float1 to float4 (s, t, r, q), of texture unit 0
  std::vector<Attribute> texcoordsAbove;  // the same of units 1, 2 ...; trailing absent ones are omitted
  Attribute secondaryColors;              // float3 or float4
  Attribute fogCoords;                    // float1
  Attribute materials;                    // uint32: index into the instance's materials
  // Of a page: uint32 per triangle, its number in the whole mesh.
  Attribute triangleNumbers;
  glm::vec3 lower{0}, upper{0};          // bounds of the finite vertices, object space
  bool opaqueColors = true;              // every vertex colour has alpha 1 (or there are none)
  bool moderate = true;                  // no normal, colour or texture coordinate is NaN or beyond 1e15
  size_t sizeBytes = 0;                  // memory this mesh owns, without the program's buffers
  std::shared_ptr<Residence> residence;  // null: the arrays are in memory

  /// Texture coordinates of a unit; null if the mesh has none.
  const Attribute* texcoordsOf(uint32_t unit) const {
    if (unit == 0) return texcoords ? &texcoords : nullptr;
    return unit <= texcoordsAbove.size() && texcoordsAbove[unit - 1] ? &texcoordsAbove[unit - 1] : nullptr;
  }
  uint32_t corner(uint32_t triangle, uint32_t k) const {
    const uint32_t corners = cornersOf(shape), i = triangle * corners + (k < corners ? k : corners - 1);
    return indices ? reinterpret_cast<const uint32_t*>(indices.data)[i] : i;
  }
  uint32_t endAt(uint32_t vertex) const {
    return ends ? *reinterpret_cast<const uint32_t*>(ends.data + static_cast<size_t>(vertex) * ends.stride)
                : 0;
  }
  glm::vec3 position(uint32_t vertex) const {
    const auto* f =
        reinterpret_cast<const float*>(positions.data + static_cast<size_t>(vertex) * positions.stride);
    return {f[0], f[1], f[2]};
  }
};
using MeshPtr = std::shared_ptr<const Mesh>;

}  // namespace gluray::scene
