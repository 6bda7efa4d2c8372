// 128-bit content hashes: the identity of geometry and call streams. Any thread.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>

namespace gluray {

/// A 128-bit content hash (XXH3). Different contents collide with probability 2^-128, so that contents with
/// equal hashes are treated as equal.
struct Hash128 {
  uint64_t low = 0, high = 0;
  bool operator==(const Hash128&) const = default;
};

/// Hash of `sizeBytes` bytes, chained to `seed`, so that several arrays can share one hash.
Hash128 hashBytes(const void* data, size_t sizeBytes, Hash128 seed = {});

/// hashBytes() for bytes that arrive in pieces.
class HashStream {
 public:
  HashStream();  // throws std::bad_alloc
  ~HashStream();
  HashStream(HashStream&&) noexcept;
  HashStream& operator=(HashStream&&) noexcept;

  void add(const void* data, size_t sizeBytes) noexcept;
  /// Returns the hash and starts the next one.
  Hash128 finishHash() noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace gluray

template <>
struct std::hash<gluray::Hash128> {
  size_t operator()(const gluray::Hash128& h) const noexcept { return h.low ^ h.high; }
};
