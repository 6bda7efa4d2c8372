#include "gl/culled/clusters/culled_mesh.h"

#include "gl/arrays/array_indices.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace gluray::gl {
namespace {

bool isFloats(const ArraySource& a) {
  return a.enabled && a.divisor == 0 && (a.type == GL_FLOAT || a.type == GL_DOUBLE) && a.size >= 2 &&
         a.size <= 4 && a.stride > 0 && !isForeign(a);
}

}  // namespace

std::shared_ptr<CulledMesh> CulledMesh::create(const RealGl& real, const ArraySource& positions,
                                               int components, const ArrayState& arrays,
                                               const Assembly& assembly, const Elements& e) {
  if (!isFloats(positions)) return nullptr;
  std::shared_ptr<CulledMesh> mesh(new CulledMesh);
  const ArrayReader reader(real, positions);
  mesh->positionStorage_ = reader.storage();
  Primitives& p = mesh->primitives_;
  p.positions = reader.data(), p.stride = static_cast<size_t>(positions.stride);
  p.components = std::min(positions.size, components), p.doubles = positions.type == GL_DOUBLE;
  p.corners = assembly.mode == GL_QUADS ? 4 : 3;
  if (!p.positions || !mesh->readIndices(real, arrays, assembly, e) || p.count == 0) return nullptr;
  mesh->findVertices();
  p.lowest = 0;
  if (mesh->end_ == 0 || mesh->end_ > reader.available()) return nullptr;
  if (!mesh->positionStorage_) mesh->copyPositions(mesh->end_);
  return mesh;
}

std::shared_ptr<CulledMesh> CulledMesh::withoutPositions(const RealGl& real, const ArrayState& arrays,
                                                         const Assembly& assembly, const Elements& e) {
  std::shared_ptr<CulledMesh> mesh(new CulledMesh);
  Primitives& p = mesh->primitives_;
  p.stride = 4 * sizeof(float), p.components = 4;
  p.corners = assembly.mode == GL_QUADS ? 4 : 3;
  if (!mesh->readIndices(real, arrays, assembly, e) || p.count == 0) return nullptr;
  mesh->findVertices();
  return mesh->end_ > p.lowest ? mesh : nullptr;
}

void CulledMesh::findVertices() {
  Primitives& p = primitives_;
  p.lowest = p.first, end_ = p.first + p.corners * p.count;
  if (!p.indices) return;
  const auto [least, most] = std::minmax_element(p.indices, p.indices + size_t{p.corners} * p.count);
  p.lowest = *least, end_ = 1 + *most;
}

void CulledMesh::takePositions(const std::byte* positions) {
  copied_.assign(positions, positions + primitives_.stride * (end_ - primitives_.lowest));
  primitives_.positions = copied_.data();
}

void CulledMesh::refit(const std::byte* positions) {
  primitives_.positions = positions;
  clusters_->refit(primitives_);
  primitives_.positions = nullptr;
}

void CulledMesh::refit(const std::byte* positions, size_t step, uint32_t units) {
  primitives_.positions = positions;
  units_.find(*clusters_, primitives_, step, units);
  primitives_.positions = nullptr;
}

bool CulledMesh::readIndices(const RealGl& real, const ArrayState& arrays, const Assembly& assembly,
                             const Elements& e) {
  const GLenum mode = assembly.mode;
  Primitives& p = primitives_;
  const uint32_t whole = static_cast<uint32_t>(e.count) / p.corners * p.corners;
  if ((mode == GL_TRIANGLES || mode == GL_QUADS) && !e.type) {
    p.first = static_cast<uint32_t>(e.first), p.count = whole / p.corners;
    return true;
  }
  PlainIndices plain = plainIndices(real, arrays, mode, e);
  if (!assembly.restart && plain.data && plain.storage && plain.count == whole) {
    p.indices = plain.data, p.count = static_cast<uint32_t>(plain.count / 3);
    indexStorage_ = std::move(plain.storage);
    return true;
  }
  std::vector<uint32_t> numbers = vertexNumbers(real, arrays, e);
  if (numbers.size() != static_cast<size_t>(e.count)) return false;
  numbers_ = assembly.corners(std::move(numbers));
  p.indices = numbers_.data(), p.count = static_cast<uint32_t>(numbers_.size() / p.corners);
  return true;
}

/// Copies the positions, because the program may change its memory before the clusters are built.
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
