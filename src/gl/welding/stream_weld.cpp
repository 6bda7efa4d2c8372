#include "gl/welding/stream_weld.h"

#include <algorithm>
#include <cstring>
#include <type_traits>

namespace gluray::gl {
namespace {

constexpr uint32_t kPairs = 1u << 16;  // 1 MiB: fits into the caches
constexpr uint32_t kNone = ~0u;

uint32_t pairOf(uint64_t hash) { return static_cast<uint32_t>(hash >> 40) & (kPairs - 1); }
uint32_t tagOf(uint64_t hash) { return static_cast<uint32_t>(hash); }

/// S: floats per vertex; 0: `stride` gives their number at run time.
template <uint32_t S, class Float = float>
struct Vertices {
  Float* data;
  uint32_t stride;
  uint32_t floats() const { return S ? S : stride; }
  Float* operator[](uint32_t i) const { return data + size_t{i} * floats(); }

  uint64_t hash(const float* v) const {
    uint64_t h = 0x9E3779B97F4A7C15ull;
    uint32_t i = 0;
    for (; i + 2 <= floats(); i += 2) {
      uint64_t two;
      std::memcpy(&two, v + i, sizeof two);
      h = (h ^ two) * 0xD6E8FEB86659FD93ull;
      h ^= h >> 32;
    }
    if (i < floats()) {
      uint32_t last;
      std::memcpy(&last, v + i, sizeof last);
      h = (h ^ last) * 0xD6E8FEB86659FD93ull;
    }
    return h;
  }
  void fetch(uint32_t i) const {
    const float* v = (*this)[i];
    __builtin_prefetch(v);
    __builtin_prefetch(v + floats() - 1);
  }
  bool equal(const float* a, const float* b) const {
    return std::memcmp(a, b, floats() * sizeof(float)) == 0;
  }
};

/// Welds in groups of kAhead vertices: prefetches their table entries, then the kept vertices with equal
/// tags, which are far apart in memory, and compares only those.
template <uint32_t S>
uint32_t weldInto(WeldEntry* table, const Vertices<S>& vertices, uint32_t kept,
                  const Vertices<S, const float>& arrived, uint32_t end, uint32_t* index) {
  constexpr uint32_t kAhead = 32;  // vertices
  uint64_t hashes[kAhead];
  for (uint32_t start = 0; start < end; start += kAhead) {
    const uint32_t count = std::min(kAhead, end - start);
    for (uint32_t k = 0; k < count; ++k) {
      hashes[k] = vertices.hash(arrived[start + k]);
      __builtin_prefetch(table + 2 * pairOf(hashes[k]));
    }
    for (uint32_t k = 0; k < count; ++k) {
      const WeldEntry* pair = table + 2 * pairOf(hashes[k]);
      for (const WeldEntry* entry : {pair, pair + 1})
        if (entry->tag == tagOf(hashes[k]) && entry->vertex != kNone) vertices.fetch(entry->vertex);
    }
    for (uint32_t k = 0; k < count; ++k) {
      const float* v = arrived[start + k];
      const uint32_t tag = tagOf(hashes[k]);
      WeldEntry* pair = table + 2 * pairOf(hashes[k]);
      const auto holds = [&](const WeldEntry& entry) {
        return entry.tag == tag && entry.vertex != kNone && vertices.equal(vertices[entry.vertex], v);
      };
      if (holds(pair[0])) {
      } else if (holds(pair[1])) {
        std::swap(pair[0], pair[1]);
      } else {
        if (vertices[kept] != v) std::memcpy(vertices[kept], v, vertices.floats() * sizeof(float));
        pair[1] = pair[0];
        pair[0] = {kept++, tag};
      }
      *index++ = pair[0].vertex;
    }
  }
  return kept;
}

}  // namespace

uint32_t StreamWelder::weld(float* vertices, uint32_t stride, uint32_t kept, const float* arrived,
                            uint32_t count, GrowingArray<uint32_t>& indices) {
  if (table_.empty()) {
    table_.resize(2 * kPairs);
    std::fill(table_.begin(), table_.end(), WeldEntry{kNone, 0});
  }
  const size_t before = indices.size();
  indices.grow(before + count);
  const auto weldAs = [&]<uint32_t S>(std::integral_constant<uint32_t, S>) {
    return weldInto<S>(table_.data(), {vertices, stride}, kept, {arrived, stride}, count,
                       indices.data() + before);
  };
  switch (stride) {
    case 3: return weldAs(std::integral_constant<uint32_t, 3>());
    case 6: return weldAs(std::integral_constant<uint32_t, 6>());
    case 10: return weldAs(std::integral_constant<uint32_t, 10>());
    default: return weldAs(std::integral_constant<uint32_t, 0>());
  }
}

}  // namespace gluray::gl
