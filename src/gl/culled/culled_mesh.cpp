#include "gl/culled/culled_mesh.h"

#include "gl/arrays/array_indices.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace gluray::gl {
namespace {

/// Corners of the triangles of a strip or fan, in the order in which the real OpenGL makes them where the
/// last vertex provokes.
std::vector<uint32_t> separated(const std::vector<uint32_t>& numbers, GLenum mode) {
  std::vector<uint32_t> corners;
  if (numbers.size() < 3) return corners;
  corners.reserve(3 * (numbers.size() - 2));
  for (size_t i = 0; i + 2 < numbers.size(); ++i) {
    const size_t odd = i & 1;
    const size_t a = mode == GL_TRIANGLE_FAN ? 0 : i + odd;
    const size_t b = mode == GL_TRIANGLE_FAN ? i + 1 : i + 1 - odd;
    for (const size_t corner : {a, b, i + 2}) corners.push_back(numbers[corner]);
  }
  return corners;
}

bool isFloats(const ArraySource& a) {
  return a.enabled && a.divisor == 0 && (a.type == GL_FLOAT || a.type == GL_DOUBLE) && a.size >= 2 &&
         a.size <= 4 && a.stride > 0 && !isForeign(a);
}

}  // namespace

std::shared_ptr<CulledMesh> CulledMesh::of(const RealGl& real, const ArraySource& positions, int components,
                                           const ArrayState& arrays, GLenum mode, const Elements& e) {
  if (!isFloats(positions)) return nullptr;
  std::shared_ptr<CulledMesh> mesh(new CulledMesh);
  const ArrayReader reader(real, positions);
  mesh->positionStorage_ = reader.storage();
  Primitives& p = mesh->primitives_;
  p.positions = reader.data(), p.stride = static_cast<size_t>(positions.stride);
  p.components = std::min(positions.size, components), p.doubles = positions.type == GL_DOUBLE;
  p.corners = mode == GL_QUADS ? 4 : 3;
  if (!p.positions || !mesh->readIndices(real, arrays, mode, e) || p.count == 0) return nullptr;
  uint32_t end = p.first + p.corners * p.count;  // past the last vertex
  if (p.indices) end = 1 + *std::max_element(p.indices, p.indices + size_t{p.corners} * p.count);
  if (end == 0 || end > reader.available()) return nullptr;
  if (!mesh->positionStorage_) mesh->copyPositions(end);
  return mesh;
}

bool CulledMesh::readIndices(const RealGl& real, const ArrayState& arrays, GLenum mode, const Elements& e) {
  Primitives& p = primitives_;
  const uint32_t whole = static_cast<uint32_t>(e.count) / p.corners * p.corners;
  if ((mode == GL_TRIANGLES || mode == GL_QUADS) && !e.type) {
    p.first = static_cast<uint32_t>(e.first), p.count = whole / p.corners;
    return true;
  }
  PlainIndices plain = plainIndices(real, arrays, mode, e);
  if (plain.data && plain.storage && plain.count == whole) {
    p.indices = plain.data, p.count = static_cast<uint32_t>(plain.count / 3);
    indexStorage_ = std::move(plain.storage);
    return true;
  }
  std::vector<uint32_t> numbers = vertexNumbers(real, arrays, e);
  if (numbers.size() != static_cast<size_t>(e.count)) return false;
  const bool separate = mode == GL_TRIANGLES || mode == GL_QUADS;
  numbers_ = separate ? std::move(numbers) : separated(numbers, mode);
  p.indices = numbers_.data(), p.count = static_cast<uint32_t>(numbers_.size() / p.corners);
  return true;
}

/// The program may change its memory before the clusters are built.
void CulledMesh::copyPositions(uint32_t end) {
  const size_t each =
      static_cast<size_t>(primitives_.components) * (primitives_.doubles ? sizeof(double) : sizeof(float));
  copied_.resize(each * end);
  for (size_t i = 0; i < end; ++i)
    std::memcpy(copied_.data() + each * i, primitives_.positions + primitives_.stride * i, each);
  primitives_.positions = copied_.data(), primitives_.stride = each;
}

void CulledMesh::build() { clusters_.emplace(primitives_); }

}  // namespace gluray::gl
