// The vertices of a node in world space, in pieces, for formats without matrices. One thread.
#pragma once
#include "saved/export/gather/exported_scene.h"

#include <algorithm>
#include <vector>

namespace gluray::saved {

/// A node's mesh in world space.
ExportedMesh worldMesh(const ExportedScene&, const ExportedNode&);

struct VertexPiece {
  std::vector<glm::vec3> positions, normals;  // normals, colors, texcoords: empty if the mesh has none
  std::vector<glm::vec4> colors;              // displayed values
  std::vector<glm::vec2> texcoords;
};

/// Vertices [first, first + count).
VertexPiece vertexPiece(const ExportedMesh&, size_t first, size_t count);
/// Indices of elements [first, first + count).
std::vector<uint32_t> indexPiece(const ExportedMesh&, size_t first, size_t count);

constexpr size_t kVertexPiece = 3 << 15;  // a multiple of the corners of every primitive

/// Calls body(first, count) for pieces of [0, total); ends early, with false, where it returns false.
template <class Body>
bool inPieces(size_t total, const Body& body) {
  for (size_t first = 0; first < total; first += kVertexPiece)
    if (!body(first, std::min(kVertexPiece, total - first))) return false;
  return true;
}

}  // namespace gluray::saved
