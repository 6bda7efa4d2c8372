#include "saved/export/formats/ply_writer.h"

#include "saved/export/formats/world_vertices.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace gluray::saved {
namespace {

std::string headerOf(size_t vertices, size_t faces, bool normals) {
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment GLuRay " GLURAY_VERSION
                     "\nelement vertex " +
                     std::to_string(vertices) + "\n";
  for (const char* name : {"x", "y", "z"}) text += std::string("property float ") + name + "\n";
  for (const char* name : {"nx", "ny", "nz"})
    if (normals) text += std::string("property float ") + name + "\n";
  for (const char* name : {"red", "green", "blue", "alpha"})
    text += std::string("property uchar ") + name + "\n";
  if (faces) text += "element face " + std::to_string(faces) + "\nproperty list uchar int vertex_indices\n";
  return text + "end_header\n";
}

uint8_t byteOfColor(float v) {
  return static_cast<uint8_t>(std::lround(255 * std::min(std::max(v, 0.0f), 1.0f)));
}

void append(std::string& out, const void* bytes, size_t size) {
  out.append(static_cast<const char*>(bytes), size);
}

bool writeVertices(const ExportedMesh& mesh, const glm::vec4& factor, bool normals, files::Draft& draft) {
  return inPieces(mesh.positions->count(), [&](size_t first, size_t count) {
    const VertexPiece piece = vertexPiece(mesh, first, count);
    std::string out;
    out.reserve(count * 28);
    for (size_t i = 0; i < count; ++i) {
      append(out, &piece.positions[i], 12);
      const glm::vec3 none(0);
      if (normals) append(out, piece.normals.empty() ? &none : &piece.normals[i], 12);
      const glm::vec4 color = piece.colors.empty() ? factor : factor * piece.colors[i];
      for (int c = 0; c < 4; ++c) out.push_back(static_cast<char>(byteOfColor(color[c])));
    }
    return draft.write(out);
  });
}

bool writeFaces(const ExportedMesh& mesh, uint32_t firstVertex, files::Draft& draft) {
  return inPieces(mesh.elementCount(), [&](size_t first, size_t count) {
    const std::vector<uint32_t> indices = indexPiece(mesh, first, count);
    std::string out;
    out.reserve(count / 3 * 13);
    for (size_t i = 0; i < count; ++i) {
      if (i % 3 == 0) out.push_back(3);
      const uint32_t index = firstVertex + indices[i];
      append(out, &index, 4);
    }
    return draft.write(out);
  });
}

}  // namespace

std::string writePly(const ExportedScene& scene, files::Draft& draft) {
  const std::vector<ExportedNode>& nodes = scene.views.front().nodes;
  size_t vertices = 0, faces = 0;
  bool normals = false;
  for (const ExportedNode& node : nodes) {
    const ExportedMesh& mesh = scene.meshes[node.mesh];
    vertices += mesh.positions->count(), normals |= mesh.normals != nullptr;
    if (mesh.mode == MeshMode::triangles) faces += mesh.elementCount() / 3;
  }
  if (vertices > std::numeric_limits<int32_t>::max())
    return "the scene has " + std::to_string(vertices) +
           " vertices, and PLY files at most 2^31: show less of it";
  if (!draft.write(headerOf(vertices, faces, normals))) return "";
  for (const ExportedNode& node : nodes) {
    const ExportedMesh mesh = worldMesh(scene, node);
    if (!writeVertices(mesh, scene.materials[mesh.material].color, normals, draft)) return "";
  }
  uint32_t first = 0;
  for (const ExportedNode& node : nodes) {
    const ExportedMesh mesh = worldMesh(scene, node);
    if (mesh.mode == MeshMode::triangles && !writeFaces(mesh, first, draft)) return "";
    first += static_cast<uint32_t>(mesh.positions->count());
  }
  return "";
}

}  // namespace gluray::saved
