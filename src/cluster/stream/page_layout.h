// Pages in messages: parts of large meshes whose arrays are sent when a ray hits their bounds, not before the
// snapshot. All arrays of a page are in one block of memory. Any thread.
#pragma once
#include "base/hash.h"
#include "scene/mesh.h"
#include "scene/residence.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

namespace gluray::cluster {

struct PageName {
  Hash128 id;                 // of its content
  int32_t owner = 0;          // the rank of the job that has it
  uint32_t mostMaterial = 0;  // the largest number of a material of its vertices
  std::optional<scene::Residence::Whole> whole;
};

/// Instance::triangleColors, triangleNormals and triangleEdges.
using TriangleArrays = std::array<scene::Attribute, 3>;

/// The residence of a page. The sender's residence is never loaded.
class PageResidence : public scene::Residence {
 public:
  explicit PageResidence(PageName name) : name(std::move(name)) {}
  const PageName name;
  TriangleArrays ofTriangles;  // of all instances of the mesh

  bool load() noexcept override { return false; }
  void fail(const char*) noexcept override {}
  void drop() noexcept override {}
  size_t bytes() const noexcept override { return 0; }
  const Whole* whole() const noexcept override { return name.whole ? &*name.whole : nullptr; }
  size_t budget() const noexcept override { return 0; }
};

/// Calls f(attribute, elements) for each array that a page may have, in the order in which they lie in
/// memory.
template <class Mesh, class Arrays, class F>
void eachArray(Mesh& mesh, Arrays& ofTriangles, const F& f) {
  const uint32_t vertices = mesh.vertexCount, triangles = mesh.triangleCount;
  f(mesh.positions, vertices);
  f(mesh.indices, 3 * triangles);
  for (auto* a : {&mesh.normals, &mesh.colors, &mesh.texcoords, &mesh.secondaryColors, &mesh.fogCoords,
                  &mesh.materials})
    f(*a, vertices);
  for (auto& a : mesh.texcoordsAbove) f(a, vertices);
  f(mesh.triangleNumbers, triangles);
  for (auto& a : ofTriangles) f(a, triangles);
}

/// Bytes of the arrays of these formats, with the padding that scene/mesh.h promises.
size_t pageBytes(const scene::Mesh& mesh, const TriangleArrays& ofTriangles);
/// Places the arrays of these formats into pageBytes() bytes, which `owner` keeps alive.
void layOut(scene::Mesh& mesh, TriangleArrays& ofTriangles, const std::shared_ptr<std::byte>& memory);

/// Limits that loading checks, because pages are untrusted.
struct PageLimits {
  scene::Attribute indices, materials;
  uint32_t corners = 0, vertices = 0;
};

/// Makes pages that can be loaded, for SnapshotDecoder.
class PageSource {
 public:
  virtual ~PageSource() = default;
  struct Made {
    std::shared_ptr<PageResidence> page;
    std::shared_ptr<std::byte> memory;  // for its arrays: zeros until it is loaded
  };
  /// Returns the same page for the same `identity` (hash of name and formats) while it exists. Throws
  /// std::bad_alloc.
  virtual Made make(const Hash128& identity, const PageName& name, size_t bytes) = 0;
  /// Sets the limits of a page. Call before the page is loaded.
  virtual void limit(PageResidence& page, const PageLimits& limits) = 0;
};

}  // namespace gluray::cluster
