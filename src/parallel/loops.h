// Parallel loops over large arrays. Any thread.
#pragma once
#include "base/hash.h"
#include "parallel/arena.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <cstddef>
#include <cstdint>
#include <functional>

namespace gluray {

/// Calls body(first, last) for pieces of at most about `grain` elements that partition [0, count), on the
/// threads of sharedArena().
template <class Body>
void forPieces(size_t count, size_t grain, const Body& body) {
  using Range = tbb::blocked_range<size_t>;
  if (count == 0) return;
  if (count <= grain) return body(size_t{0}, count);
  sharedArena()->execute([&] {
    tbb::parallel_for(Range(0, count, grain), [&](const Range& piece) { body(piece.begin(), piece.end()); });
  });
}

/// Parallel reduction: body(first, last, T so far) returns the new T, join(a, b) combines two.
template <class T, class Body, class Join>
T reducePieces(size_t count, size_t grain, const T& none, const Body& body, const Join& join) {
  using Range = tbb::blocked_range<size_t>;
  if (count <= grain) return count ? body(size_t{0}, count, none) : none;
  return sharedArena()->execute([&] {
    return tbb::parallel_reduce(
        Range(0, count, grain), none,
        [&](const Range& piece, const T& before) { return body(piece.begin(), piece.end(), before); }, join);
  });
}

/// Calls work(0) to work(count - 1) on `threads` threads (0: as many as the process may use), the caller's
/// included. Throws what `work` does, and std::bad_alloc.
void forEachPart(int threads, int count, const std::function<void(int)>& work);

/// Content hash of `sizeBytes` bytes: the hash of the hashes of pieces if there are many. Differs from
/// hashBytes().
Hash128 hashLarge(const void* data, size_t sizeBytes, Hash128 seed = {});

/// Minimum and maximum.
struct Extremes {
  uint32_t least = ~0u, most = 0;  // unchanged if there are no numbers
};
Extremes extremesOf(const uint32_t* numbers, size_t count);

/// target[i] = source[i] - lower.
void copyNumbers(uint32_t* target, const uint32_t* source, size_t count, uint32_t lower);

/// Parallel memcpy.
void copyLarge(void* target, const void* source, size_t sizeBytes);

}  // namespace gluray
