#include "saved/export/formats/world_vertices.h"

#include "saved/export/gather/scene_parts.h"

#include <numeric>

namespace gluray::saved {
namespace {

template <class T>
std::vector<T> pieceOf(const SourcePtr& source, size_t first, size_t count) {
  std::vector<T> out(source ? count : 0);
  if (source) readAll(*source, first, count, reinterpret_cast<std::byte*>(out.data()));
  return out;
}

}  // namespace

ExportedMesh worldMesh(const ExportedScene& scene, const ExportedNode& node) {
  const ExportedMesh& mesh = scene.meshes[node.mesh];
  return node.worldFromMesh == glm::dmat4(1) ? mesh : moved(mesh, node.worldFromMesh);
}

VertexPiece vertexPiece(const ExportedMesh& mesh, size_t first, size_t count) {
  VertexPiece piece;
  piece.positions = pieceOf<glm::vec3>(mesh.positions, first, count);
  piece.normals = pieceOf<glm::vec3>(mesh.normals, first, count);
  piece.texcoords = pieceOf<glm::vec2>(mesh.texcoords[0], first, count);
  if (mesh.colors && mesh.colors->element() == Element::bytes4) {
    for (const uint32_t c : pieceOf<uint32_t>(mesh.colors, first, count))
      piece.colors.push_back(glm::vec4(c & 255, c >> 8 & 255, c >> 16 & 255, c >> 24) / 255.0f);
  } else {
    piece.colors = pieceOf<glm::vec4>(mesh.colors, first, count);
  }
  return piece;
}

std::vector<uint32_t> indexPiece(const ExportedMesh& mesh, size_t first, size_t count) {
  if (mesh.indices) return pieceOf<uint32_t>(mesh.indices, first, count);
  std::vector<uint32_t> out(count);
  std::iota(out.begin(), out.end(), static_cast<uint32_t>(first));
  return out;
}

}  // namespace gluray::saved
