#include "gl/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cstring>
#include <vector>

namespace gluray::gl {
namespace {
constexpr size_t kPiece = size_t{1} << 18;  // bytes
}

Hash128 hashLarge(const void* data, size_t sizeBytes, Hash128 seed) {
  if (sizeBytes <= kPiece) return hashBytes(data, sizeBytes, seed);
  const auto* bytes = static_cast<const std::byte*>(data);
  std::vector<Hash128> pieces((sizeBytes + kPiece - 1) / kPiece);
  tbb::parallel_for(size_t{0}, pieces.size(), [&](size_t i) {
    const size_t first = i * kPiece;
    pieces[i] = hashBytes(bytes + first, std::min(kPiece, sizeBytes - first));
  });
  return hashBytes(pieces.data(), pieces.size() * sizeof(Hash128), seed);
}

Extremes extremesOf(const uint32_t* numbers, size_t count) {
  return tbb::parallel_reduce(
      tbb::blocked_range<size_t>(0, count, kPiece / sizeof(uint32_t)), Extremes{},
      [&](const auto& range, Extremes e) {
        for (size_t i = range.begin(); i != range.end(); ++i)
          e.least = std::min(e.least, numbers[i]), e.most = std::max(e.most, numbers[i]);
        return e;
      },
      [](const Extremes& a, const Extremes& b) {
        return Extremes{std::min(a.least, b.least), std::max(a.most, b.most)};
      });
}

void copyNumbers(uint32_t* target, const uint32_t* source, size_t count, uint32_t lower) {
  tbb::parallel_for(tbb::blocked_range<size_t>(0, count, kPiece / sizeof(uint32_t)), [&](const auto& range) {
    for (size_t i = range.begin(); i != range.end(); ++i) target[i] = source[i] - lower;
  });
}

void copyLarge(void* target, const void* source, size_t sizeBytes) {
  if (sizeBytes == 0) return;  // an array that is not there has no address
  if (sizeBytes <= kPiece) {
    std::memcpy(target, source, sizeBytes);
    return;
  }
  tbb::parallel_for(tbb::blocked_range<size_t>(0, sizeBytes, kPiece), [&](const auto& range) {
    std::memcpy(static_cast<std::byte*>(target) + range.begin(),
                static_cast<const std::byte*>(source) + range.begin(), range.size());
  });
}

}  // namespace gluray::gl
