#include "base/hash.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace gluray {

Hash128 hashBytes(const void* data, size_t sizeBytes, Hash128 seed) {
  const XXH128_hash_t h = XXH3_128bits_withSeed(data, sizeBytes, seed.low);
  // The seed's high half is folded in as well, so that no part of a chain is forgotten.
  return {h.low64, h.high64 ^ (seed.high * 0x9E3779B97F4A7C15ull + (seed.high >> 29))};
}

}  // namespace gluray
