// Vertices that a program's vertex shader fetches from buffer textures by gl_VertexID (FamilyPulling), as
// vertex arrays. GL thread.
#pragma once
#include "gl/arrays/arrays.h"
#include "gl/real/elements.h"
#include "scene/mesh.h"

#include <cstdint>
#include <deque>
#include <optional>

namespace gluray::gl {

struct PulledVertices {
  /// An array element for each point. `elements`: the points of the vertices or, if `indexed`, what the draw
  /// has.
  ArrayState arrays;
  size_t idsOffset = 0;   // bytes into `elements`
  GLint firstVertex = 0;  // gl_VertexID of the first vertex of draws
  bool indexed = false;   // gl_VertexID is the point
  bool lines = false;     // each two triangles that the program draws are a line of two `elements`
  /// The cell of each triangle of a draw, as signed 32-bit integers, where cells are not triangles; its
  /// format is Format::none where they are.
  scene::Attribute cells;
  uint32_t cellCount = 0;  // number of elements of `cells`
  /// So many primitives of a draw are one of the triangles that `cells` counts.
  uint32_t primitivesPerCell = 1;
  bool sortsCells() const { return cells || primitivesPerCell > 1; }
};

/// The draw as one of PulledVertices::arrays, without changing how many instances it has. Nullopt if it does
/// not begin at `firstVertex`, its indices number vertices instead of points, or `lines` are not whole.
std::optional<Elements> elementsOf(const PulledVertices& pulled, const Elements& drawn);

/// The primitives of a draw of `mode` by PulledVertices::arrays. Nullopt if the program draws no such ones.
std::optional<GLenum> modeOf(const PulledVertices& pulled, GLenum mode);

/// Values of cells, in the order of the triangles of draws. Keeps those of the last draws, so that a surface
/// that is drawn again has the same ones.
class ValuesOfCells {
 public:
  /// The elements that the first `triangles` triangles, or other primitives, select by their cells. Nullopt
  /// if one selects an element from number `count` on. May throw std::bad_alloc.
  std::optional<scene::Attribute> take(const PulledVertices& pulled, const scene::Attribute& elements,
                                       uint32_t count, uint32_t triangles);

 private:
  static constexpr size_t kMost = 64, kMostBytes = size_t{1} << 28;
  struct Known {
    scene::Attribute elements, cells;
    uint32_t count = 0, triangles = 0, each = 1;
    scene::Attribute values;
    size_t bytes() const { return size_t{values.stride} * triangles + size_t{elements.stride} * count; }
  };
  void add(Known known);

  std::deque<Known> known_;
  size_t bytes_ = 0;  // of values, and of elements that are kept for them
};

}  // namespace gluray::gl
