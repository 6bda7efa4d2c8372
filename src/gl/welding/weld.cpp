#include "gl/welding/weld.h"

#include "parallel/loops.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <vector>

namespace gluray::gl {
namespace {

constexpr uint32_t kBlock = 1u << 20;  // vertices; the hash table of a block stays in the caches
constexpr uint32_t kEmpty = ~0u;

uint32_t hashVertex(const float* v, uint32_t stride) {
  uint64_t h = 0x9E3779B97F4A7C15ull;
  for (uint32_t i = 0; i < stride; ++i)
    h = (h ^ std::bit_cast<uint32_t>(v[i])) * 0xD6E8FEB86659FD93ull, h ^= h >> 32;
  return static_cast<uint32_t>(h ^ (h >> 29));
}

struct Block {
  uint32_t first = 0, count = 0;
  std::vector<uint32_t> source;  // per representative: a soup vertex equal to it
};

/// Welds one block: sets index[i] of each of its vertices, with numbers from 0.
void weldBlock(const float* vertices, uint32_t stride, Block& block, uint32_t* index) {
  const uint32_t size = std::bit_ceil(std::max(block.count, 16u));  // at most half full for typical surfaces
  std::vector<uint32_t> table(size, kEmpty);
  const size_t bytes = stride * sizeof(float);
  for (uint32_t i = block.first; i < block.first + block.count; ++i) {
    const float* v = vertices + size_t{i} * stride;
    for (uint32_t slot = hashVertex(v, stride) & (size - 1);; slot = (slot + 1) & (size - 1)) {
      const uint32_t known = table[slot];
      if (known == kEmpty) {
        index[i] = static_cast<uint32_t>(block.source.size());
        table[slot] = index[i];
        block.source.push_back(i);
        break;
      }
      if (std::memcmp(vertices + size_t{block.source[known]} * stride, v, bytes) == 0) {
        index[i] = known;
        break;
      }
    }
  }
}

}  // namespace

Welded weld(const float* vertices, uint32_t count, uint32_t stride) {
  Welded result;
  result.index.resize(count);
  std::vector<Block> blocks;
  // Blocks are smaller than their tables: probing a full table would never end.
  const uint32_t step = kBlock - kBlock / 4;
  for (uint32_t first = 0; first < count; first += step)
    blocks.push_back({first, std::min(step, count - first), {}});
  forPieces(blocks.size(), 1, [&](size_t b, size_t last) {
    for (; b < last; ++b) weldBlock(vertices, stride, blocks[b], result.index.data());
  });
  std::vector<uint32_t> base(blocks.size() + 1, 0);
  for (size_t b = 0; b < blocks.size(); ++b)
    base[b + 1] = base[b] + static_cast<uint32_t>(blocks[b].source.size());
  result.source.resize(base.back());
  forPieces(blocks.size(), 1, [&](size_t b, size_t last) {
    for (; b < last; ++b) {
      for (uint32_t i = 0; i < blocks[b].count; ++i) result.index[blocks[b].first + i] += base[b];
      std::copy(blocks[b].source.begin(), blocks[b].source.end(), result.source.begin() + base[b]);
    }
  });
  return result;
}

}  // namespace gluray::gl
