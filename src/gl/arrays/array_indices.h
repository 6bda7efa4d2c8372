// Which vertices and triangles a draw from arrays takes, without copies of index arrays where that is
// possible. GL thread.
#pragma once
#include "gl/arrays/arrays.h"
#include "gl/draws/multipass_surfaces.h"

#include <memory>
#include <vector>

namespace gluray::gl {

/// Vertices of arrays.
struct Range {
  uint32_t lower = 0, upper = 0;  // first vertex, and one behind the last
  uint32_t count() const { return upper - lower; }
};

/// The index array of a draw of separate triangles where it lies, if its numbers can be used as they are.
struct PlainIndices {
  const uint32_t* data = nullptr;                // null: they cannot
  size_t count = 0;                              // a multiple of 3
  std::shared_ptr<const BufferStorage> storage;  // null: the program's memory
};
PlainIndices plainIndices(const RealGl& real, const ArrayState& arrays, GLenum mode,
                          const Elements& elements);

/// The triangles of a draw of surfaces, in the cheapest form that they can have.
struct Triangles {
  Range range;                    // of the vertices they use
  size_t corners = 0;             // three times their number
  PlainIndices plain;             // where the program's own numbers do
  std::vector<uint32_t> numbers;  // otherwise, unless
  bool inOrder = false;           // they are the vertices of `range` one after the other
};
/// Triangles with vertices from `available` on are left out.
Triangles trianglesOf(const RealGl& real, const ArrayState& arrays, GLenum mode, const Elements& elements,
                      uint32_t available);

/// Which vertices below `available` a draw of any kind takes.
struct Taken {
  Range range;
  GrowingArray<uint32_t>
      numbers;  // counted from range.lower; empty where the draw has no indices: all in order
};
Taken takenBy(const RealGl& real, const ArrayState& arrays, GLenum mode, const Elements& elements,
              uint32_t available);

/// The vertices of a draw, whether they exist or not, and an identity of their order.
struct Order {
  Range range;
  Hash128 identity;
};
Order orderOf(const RealGl& real, const ArrayState& arrays, GLenum mode, const Elements& elements,
              Hash128 seed);

/// Some triangles of a draw by fixed function; where impostors have more corners, three of them.
std::vector<Triangle> sampleTriangles(const RealGl& real, const ArrayState& arrays, GLenum mode,
                                      const Elements& elements);

}  // namespace gluray::gl
