// The vertices and triangles that an array draw uses. Index arrays are read in place if possible. GL thread.
#pragma once
#include "gl/arrays/arrays.h"
#include "gl/capture/triangle_samples.h"

#include <memory>
#include <vector>

namespace gluray::gl {

/// A range of array elements.
struct Range {
  uint32_t lower = 0, upper = 0;  // the first, and one past the last
  uint32_t count() const { return upper - lower; }
};

/// A draw's index array, used in place. It must be aligned, 32-bit, of separate triangles and without base
/// vertex.
struct PlainIndices {
  const uint32_t* data = nullptr;                // null: not usable in place
  size_t count = 0;                              // a multiple of 3
  std::shared_ptr<const BufferStorage> storage;  // owns `data`; null: `data` is the program's memory
};
PlainIndices plainIndices(const RealGl& real, const ArrayState& arrays, GLenum mode,
                          const Elements& elements);

/// The triangles of a surface draw, in the cheapest of three forms: `plain`, `inOrder` or `numbers`.
struct Triangles {
  Range range;                    // of the vertices that the triangles use
  size_t corners = 0;             // three times the number of triangles
  PlainIndices plain;             // the program's own indices
  std::vector<uint32_t> numbers;  // vertex numbers of all corners
  bool inOrder = false;           // the corners are the vertices of `range`, in order
};
/// The triangles of the draw, without those that use vertices from number `available` on.
Triangles trianglesOf(const RealGl& real, const ArrayState& arrays, GLenum mode, const Elements& elements,
                      uint32_t available);

/// The vertices below number `available` that a draw of any mode uses. `numbers` count from range.lower. They
/// are empty if the draw has no indices; then it uses all of `range` in order.
struct Taken {
  Range range;
  GrowingArray<uint32_t> numbers;
};
Taken takenBy(const RealGl& real, const ArrayState& arrays, GLenum mode, const Elements& elements,
              uint32_t available);

/// The vertices that a draw names, and a hash of their order that starts from `seed`. Indices may name
/// vertices that do not exist.
struct Order {
  Range range;
  Hash128 identity;
};
Order orderOf(const RealGl& real, const ArrayState& arrays, GLenum mode, const Elements& elements,
              Hash128 seed);

/// The vertices that an indexed draw names, without the index `restart`.
Range rangeWithout(const RealGl& real, const ArrayState& arrays, const Elements& elements, uint32_t restart);

/// Some triangles of a fixed-function draw; for a quad, its first three corners.
std::vector<Triangle> sampleTriangles(const RealGl& real, const ArrayState& arrays, GLenum mode,
                                      const Elements& elements);

}  // namespace gluray::gl
