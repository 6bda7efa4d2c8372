#include "parallel/loops.h"

#include <algorithm>
#include <cstring>
#include <vector>

namespace gluray {
namespace {
constexpr size_t kPiece = size_t{1} << 18;  // bytes
}

void forEachPart(int threads, int count, const std::function<void(int)>& work) {
  arenaFor(ArenaUse::other, threads)->execute([&] { tbb::parallel_for(0, count, work); });
}

Hash128 hashLarge(const void* data, size_t sizeBytes, Hash128 seed) {
  if (sizeBytes <= kPiece) return hashBytes(data, sizeBytes, seed);
  const auto* bytes = static_cast<const std::byte*>(data);
  std::vector<Hash128> pieces((sizeBytes + kPiece - 1) / kPiece);
  forPieces(pieces.size(), 1, [&](size_t first, size_t last) {
    for (size_t i = first; i < last; ++i)
      pieces[i] = hashBytes(bytes + i * kPiece, std::min(kPiece, sizeBytes - i * kPiece));
  });
  return hashBytes(pieces.data(), pieces.size() * sizeof(Hash128), seed);
}

Extremes extremesOf(const uint32_t* numbers, size_t count) {
  return reducePieces(
      count, kPiece / sizeof(uint32_t), Extremes{},
      [&](size_t first, size_t last, Extremes e) {
        for (size_t i = first; i < last; ++i)
          e.least = std::min(e.least, numbers[i]), e.most = std::max(e.most, numbers[i]);
        return e;
      },
      [](const Extremes& a, const Extremes& b) {
        return Extremes{std::min(a.least, b.least), std::max(a.most, b.most)};
      });
}

void copyNumbers(uint32_t* target, const uint32_t* source, size_t count, uint32_t lower) {
  forPieces(count, kPiece / sizeof(uint32_t), [&](size_t first, size_t last) {
    for (size_t i = first; i < last; ++i) target[i] = source[i] - lower;
  });
}

void copyLarge(void* target, const void* source, size_t sizeBytes) {
  forPieces(sizeBytes, kPiece, [&](size_t first, size_t last) {
    std::memcpy(static_cast<std::byte*>(target) + first, static_cast<const std::byte*>(source) + first,
                last - first);
  });
}

}  // namespace gluray
