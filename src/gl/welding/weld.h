// Deduplicates ("welds") the vertices of a complete triangle soup, for mesh_builder. Any thread.
#pragma once
#include "gl/basics/growing_array.h"

#include <cstdint>

namespace gluray::gl {

struct Welded {
  GrowingArray<uint32_t> index;   // per soup vertex: the number of its representative
  GrowingArray<uint32_t> source;  // per representative: a soup vertex equal to it
};

/// Gives bitwise equal vertices of `stride` floats the same number. Works in blocks on all cores, so a few
/// equal vertices in different blocks keep different numbers. Throws std::bad_alloc.
Welded weld(const float* vertices, uint32_t count, uint32_t stride);

}  // namespace gluray::gl
