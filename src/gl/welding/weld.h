// Finds equal vertices in a triangle soup. Any thread.
#pragma once
#include "gl/capture/growing_array.h"

#include <cstdint>

namespace gluray::gl {

struct Welded {
  GrowingArray<uint32_t> index;   // for each soup vertex, the number of its representative
  GrowingArray<uint32_t> source;  // for each representative, a soup vertex that equals it
};

/// Vertices of `stride` floats each that agree in every bit share a number. Works in blocks on all cores, so
/// that a few equal vertices of different blocks keep numbers of their own. Throws std::bad_alloc.
Welded weld(const float* vertices, uint32_t count, uint32_t stride);

}  // namespace gluray::gl
