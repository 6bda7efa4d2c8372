#include "base/hash.h"

#define XXH_INLINE_ALL
#ifdef __SANITIZE_ADDRESS__
#define XXH_NO_INLINE_HINTS 1  // GCC does not inline calls through constant pointers with -Og
#endif
#include <xxhash.h>

namespace gluray {

Hash128 hashBytes(const void* data, size_t sizeBytes, Hash128 seed) {
  const XXH128_hash_t h = XXH3_128bits_withSeed(data, sizeBytes, seed.low);
  // Fold in the seed's high half, too: XXH3 takes only 64 bits of seed.
  return {h.low64, h.high64 ^ (seed.high * 0x9E3779B97F4A7C15ull + (seed.high >> 29))};
}

struct HashStream::State {
  XXH3_state_t xxh;  // aligned to 64 bytes
};

HashStream::HashStream() : state_(std::make_unique<State>()) { XXH3_128bits_reset(&state_->xxh); }
HashStream::~HashStream() = default;
HashStream::HashStream(HashStream&&) noexcept = default;
HashStream& HashStream::operator=(HashStream&&) noexcept = default;

void HashStream::add(const void* data, size_t sizeBytes) noexcept {
  XXH3_128bits_update(&state_->xxh, data, sizeBytes);
}

Hash128 HashStream::finishHash() noexcept {
  const XXH128_hash_t h = XXH3_128bits_digest(&state_->xxh);
  XXH3_128bits_reset(&state_->xxh);
  return {h.low64, h.high64};
}

}  // namespace gluray
