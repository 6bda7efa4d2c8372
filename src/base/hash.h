// 128-bit content hashes: how geometry and streams of calls are known again. Any thread.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>

namespace gluray {

/// A 128-bit content hash (XXH3). Two different contents share one with probability 2^-128, so equal means
/// equal.
struct Hash128 {
  uint64_t low = 0, high = 0;
  bool operator==(const Hash128&) const = default;
};

/// Hash of `sizeBytes` bytes, chained to `seed` so that several arrays make one identity.
Hash128 hashBytes(const void* data, size_t sizeBytes, Hash128 seed = {});

}  // namespace gluray

template <>
struct std::hash<gluray::Hash128> {
  size_t operator()(const gluray::Hash128& h) const noexcept { return h.low ^ h.high; }
};
