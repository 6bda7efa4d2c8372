// The arrays of meshes as arrays of exported files. Any thread.
#pragma once
#include "saved/export/arrays/array_source.h"

#include <glm/glm.hpp>

#include <memory>
#include <optional>
#include <vector>

namespace gluray::saved {

/// Vertices of a file that are the corners of a mesh's primitives, one primitive after the other, instead of
/// the mesh's vertices.
struct Corners {
  scene::MeshPtr mesh;
  std::vector<uint32_t> primitives;  // their numbers
  bool all = true;                   // all of the mesh's; `primitives` is empty
  uint32_t each = 3;                 // corners of a primitive

  size_t primitiveCount() const { return all ? mesh->triangleCount : primitives.size(); }
  size_t count() const { return primitiveCount() * each; }
  uint32_t primitiveOf(size_t vertex) const {
    const auto i = static_cast<uint32_t>(vertex / each);
    return all ? i : primitives[i];
  }
  uint32_t vertexOf(size_t vertex) const {
    return mesh->corner(primitiveOf(vertex), static_cast<uint32_t>(vertex % each));
  }
};
using CornersPtr = std::shared_ptr<const Corners>;

/// Which element of an attribute a vertex takes: its own, that of its primitive's last vertex (flat shading),
/// or that of its primitive.
enum class Pick : uint8_t { vertex, last, primitive };

/// An attribute of the mesh's vertices, or of `corners` if that is not null. The element is float2, float3 or
/// float4, or bytes4 for attributes that have them. `pick` other than vertex needs corners; `offset`: index
/// of the element of primitive 0.
SourcePtr attributeArray(const scene::MeshPtr&, const scene::Attribute&, Element, const CornersPtr& corners,
                         Pick pick = Pick::vertex, uint32_t offset = 0);

/// Indices of the primitives' corners; null if the vertices are used one after another.
SourcePtr indexArray(const scene::MeshPtr&, const CornersPtr& corners);

/// Triangles with the opposite winding. `indices`: null if the `count` vertices are used one after another.
SourcePtr reversedIndices(const SourcePtr& indices, size_t count);

/// Unit vectors of float3; (0, 0, 1) where there is no direction.
SourcePtr unitArray(SourcePtr);

/// Whether all elements are finite, and their bounds over each component. Float elements.
struct Extent {
  bool finite = true;
  glm::vec4 lower{0}, upper{0};
};
Extent extentOf(const ArraySource&);

/// The primitives all of whose positions are finite.
std::vector<uint32_t> finitePrimitives(const scene::Mesh&);

/// Whether most triangles' windings disagree with the normals of their vertices.
bool isInsideOut(const scene::Mesh&);

}  // namespace gluray::saved
