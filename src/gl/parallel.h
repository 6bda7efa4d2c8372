// Passes over large arrays on all cores. Any thread.
#pragma once
#include "base/hash.h"

#include <cstddef>
#include <cstdint>

namespace gluray::gl {

/// Identity of `sizeBytes` bytes, as a hash of the hashes of pieces where they are many. Not the value of
/// hashBytes.
Hash128 hashLarge(const void* data, size_t sizeBytes, Hash128 seed = {});

/// The smallest and the largest of numbers.
struct Extremes {
  uint32_t least = ~0u, most = 0;  // as they are where there are no numbers
};
Extremes extremesOf(const uint32_t* numbers, size_t count);

/// target[i] = source[i] - lower.
void copyNumbers(uint32_t* target, const uint32_t* source, size_t count, uint32_t lower);

/// memcpy.
void copyLarge(void* target, const void* source, size_t sizeBytes);

}  // namespace gluray::gl
