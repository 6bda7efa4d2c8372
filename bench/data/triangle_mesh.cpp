#include "bench/data/triangle_mesh.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace gluray::bench {
namespace {

constexpr size_t kElementsPerBlock = 1 << 16;

/// Appends the bytes of `value` at `to` and returns the place behind them.
template <typename T>
uint8_t* put(uint8_t* to, const T& value) {
  std::memcpy(to, &value, sizeof value);
  return to + sizeof value;
}

/// Writes `count` elements of `elementBytes` bytes each, `encode(i, to)` filling one, through a block buffer.
template <typename Encode>
bool writeElements(FILE* file, size_t count, size_t elementBytes, const Encode& encode) {
  std::vector<uint8_t> block(kElementsPerBlock * elementBytes);
  for (size_t first = 0; first < count; first += kElementsPerBlock) {
    const size_t last = std::min(count, first + kElementsPerBlock);
    for (size_t i = first; i < last; ++i) encode(i, block.data() + (i - first) * elementBytes);
    const size_t bytes = (last - first) * elementBytes;
    if (std::fwrite(block.data(), 1, bytes, file) != bytes) return false;
  }
  return true;
}

bool writeBody(const TriangleMesh& mesh, FILE* file) {
  const int header = std::fprintf(file,
                                  "ply\nformat binary_little_endian 1.0\nelement vertex %zu\n"
                                  "property float x\nproperty float y\nproperty float z\n"
                                  "property float nx\nproperty float ny\nproperty float nz\n"
                                  "element face %zu\nproperty list uchar int vertex_indices\nend_header\n",
                                  mesh.positions.size(), mesh.triangleCount());
  return header > 0 &&
         writeElements(file, mesh.positions.size(), 24,
                       [&](size_t i, uint8_t* to) { put(put(to, mesh.positions[i]), mesh.normals[i]); }) &&
         writeElements(file, mesh.triangleCount(), 13, [&](size_t i, uint8_t* to) {
           *to++ = 3;
           for (size_t corner = 0; corner < 3; ++corner) to = put(to, mesh.indices[3 * i + corner]);
         });
}

}  // namespace

TriangleMesh joined(std::vector<TriangleMesh> meshes) {
  size_t vertices = 0, indices = 0;
  for (const TriangleMesh& mesh : meshes) vertices += mesh.positions.size(), indices += mesh.indices.size();
  if (vertices > std::numeric_limits<uint32_t>::max())
    throw std::runtime_error("the mesh has more vertices than its indices can tell");
  TriangleMesh out;
  out.positions.reserve(vertices + 2);
  out.normals.reserve(vertices);
  out.indices.reserve(indices);
  for (TriangleMesh& mesh : meshes) {
    const auto before = uint32_t(out.positions.size());
    out.positions.insert(out.positions.end(), mesh.positions.begin(), mesh.positions.end());
    out.normals.insert(out.normals.end(), mesh.normals.begin(), mesh.normals.end());
    for (const uint32_t index : mesh.indices) out.indices.push_back(before + index);
    mesh = {};
  }
  return out;
}

void writePly(const TriangleMesh& mesh, const std::string& path) {
  const std::string draft = path + ".part";
  FILE* file = std::fopen(draft.c_str(), "wb");
  if (!file) throw std::runtime_error(draft + ": cannot be written: " + std::strerror(errno));
  const bool written = writeBody(mesh, file);
  const bool closed = std::fclose(file) == 0;
  if (!written || !closed || std::rename(draft.c_str(), path.c_str()) != 0) {
    std::remove(draft.c_str());
    throw std::runtime_error(path + ": writing failed: " + std::strerror(errno));
  }
}

}  // namespace gluray::bench
