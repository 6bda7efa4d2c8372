#include "base/hash.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace gluray {

Hash128 hashBytes(const void* data, size_t sizeBytes, Hash128 seed) {
  const XXH128_hash_t h = XXH3_128bits_withSeed(data, sizeBytes, seed.low);
  // Fold in the seed's high half, too: XXH3 takes only 64 bits of seed.
  return {h.low64, h.high64 ^ (seed.high * 0x9E3779B97F4A7C15ull + (seed.high >> 29))};
}

}  // namespace gluray
