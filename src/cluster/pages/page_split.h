// Divides a mesh into pages of neighbouring triangles, independent of the order of the program's triangles.
#pragma once
#include "scene/mesh.h"
#include "scene/residence.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gluray::cluster {

struct PageRange {
  size_t first = 0;  // in PageTable::triangles
  uint32_t count = 0;
  uint32_t vertices = 0;         // number of different vertices of its triangles
  glm::vec3 lower{1}, upper{0};  // of what rays may hit, object space; lower > upper: nothing
};

struct PageTable {
  std::vector<uint32_t> triangles;  // of the mesh; each page's in rising order
  std::vector<PageRange> pages;
  scene::Residence::Whole whole;
};

/// Pages of at most `most` triangles, in the order of a Morton curve. Triangles with the same box lie in the
/// same page or, where there are too many of them, in pages in the order of their numbers. The mesh is one of
/// triangles. With the threads of the current arena. Throws std::bad_alloc.
PageTable cutIntoPages(const scene::Mesh& mesh, uint32_t most);

/// Numbers from 0 for the vertices of a page's triangles, in the order of their first use.
class VertexNumbers {
 public:
  /// For `triangles` triangles.
  explicit VertexNumbers(uint32_t triangles);
  uint32_t numberOf(uint32_t vertex);
  /// By number.
  const std::vector<uint32_t>& vertices() const { return vertices_; }

 private:
  static constexpr uint32_t kNone = 0xFFFFFFFF;
  struct Slot {
    uint32_t vertex = 0, number = kNone;
  };
  std::vector<Slot> slots_;  // open addressing; a power of two
  std::vector<uint32_t> vertices_;
};

}  // namespace gluray::cluster
