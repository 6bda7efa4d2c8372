#include "gl/culled/clusters/clusters.h"

#include "parallel/loops.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace gluray::gl {
namespace {

constexpr size_t kClusterGrain = 4096;  // clusters

/// Spreads the lowest 21 bits to every third bit.
uint64_t spread3(uint64_t v) {
  v &= 0x1fffff;
  v = (v | v << 32) & 0x1f00000000ffff;
  v = (v | v << 16) & 0x1f0000ff0000ff;
  v = (v | v << 8) & 0x100f00f00f00f00f;
  v = (v | v << 4) & 0x10c30c30c30c30c3;
  return (v | v << 2) & 0x1249249249249249;
}

glm::dvec4 middleOf(const Primitives& p, uint32_t primitive) {
  glm::dvec4 sum(0);
  for (uint32_t c = 0; c < p.corners; ++c) sum += p.position(p.vertex(primitive, c));
  return sum / double(p.corners);
}

struct Bounds4 {
  glm::dvec4 lower{std::numeric_limits<double>::infinity()}, upper{-std::numeric_limits<double>::infinity()};
  bool finite = true;
  void add(const glm::dvec4& p) { lower = glm::min(lower, p), upper = glm::max(upper, p); }
  double diagonal() const { return glm::length(glm::dvec3(upper) - glm::dvec3(lower)); }
};

/// Bounds of all vertices of primitives. `each` calls its argument with the number of each vertex.
template <class Each>
Bounds4 boundsOf(const Primitives& primitives, const Each& each) {
  Bounds4 bounds;
  if (primitives.components == 4 && !primitives.doubles) {  // without a loop for each component
    glm::vec4 lower(std::numeric_limits<float>::infinity()), upper(-lower), sum(0);
    each([&](uint32_t vertex) {
      glm::vec4 p;
      std::memcpy(&p, primitives.positions + size_t{vertex - primitives.lowest} * primitives.stride,
                  sizeof p);
      lower = glm::min(lower, p), upper = glm::max(upper, p), sum += 0.0f * p;
    });
    bounds.lower = glm::dvec4(lower), bounds.upper = glm::dvec4(upper);
    bounds.finite = sum == glm::vec4(0);
    return bounds;
  }
  each([&](uint32_t vertex) {
    const glm::dvec4 p = primitives.position(vertex);
    bounds.finite = bounds.finite && std::isfinite(p.x + p.y + p.z + p.w);
    bounds.add(p);
  });
  return bounds;
}

}  // namespace

void Clusters::all(std::vector<uint64_t>& visible) const {
  visible.assign(words(), ~uint64_t{0});
  if (count() % 64) visible.back() = (uint64_t{1} << count() % 64) - 1;
}

bool Clusters::anyMayShow(const BoxVisibility& view) const {
  const auto shows = [&](const Box& box) {
    return !box.isFinite() || view.mayShow(glm::dvec4(box.center), glm::dvec4(box.extent));
  };
  const auto anyIn = [&](const Boxes& boxes, size_t group, const auto& each) {
    for (size_t i = kGroup * group; i < std::min(boxes.size(), kGroup * (group + 1)); ++i)
      if (shows(boxes[i]) && each(i)) return true;
    return false;
  };
  if (!shows(all_)) return false;
  for (size_t large = 0; large < largeGroups_.size(); ++large) {
    const auto anyOf = [&](size_t group) { return anyIn(boxes_, group, [](size_t) { return true; }); };
    if (shows(largeGroups_[large]) && anyIn(groups_, large, anyOf)) return true;
  }
  return false;
}

glm::dvec4 Primitives::position(uint32_t vertex) const {
  const std::byte* const at = positions + size_t{vertex - lowest} * stride;
  glm::dvec4 p(0, 0, 0, 1);
  for (int c = 0; c < components; ++c) {
    if (doubles) {
      double value;
      std::memcpy(&value, at + sizeof(double) * static_cast<size_t>(c), sizeof value);
      p[c] = static_cast<float>(value);  // shaders get single precision
    } else {
      float value;
      std::memcpy(&value, at + sizeof(float) * static_cast<size_t>(c), sizeof value);
      p[c] = double{value};
    }
  }
  return p;
}

Clusters::Clusters(const Primitives& primitives) : primitives_(primitives.count) {
  boxes_.resize((primitives.count + kPrimitives - 1) / kPrimitives);
  findBoxes(primitives);
  if (!areScattered(primitives)) return;
  sort(primitives);
  findBoxes(primitives);
}

uint32_t Clusters::primitivesOf(uint32_t cluster) const {
  return std::min(kPrimitives, primitives_ - cluster * kPrimitives);
}

void Clusters::findBoxes(const Primitives& primitives) {
  forPieces(boxes_.size(), kClusterGrain, [&](size_t first, size_t last) {
    for (size_t i = first; i < last; ++i) {
      const auto cluster = static_cast<uint32_t>(i);
      const Bounds4 bounds = boundsOf(primitives, [&](const auto& add) {
        for (uint32_t k = 0; k < primitivesOf(cluster); ++k)
          for (uint32_t c = 0; c < primitives.corners; ++c)
            add(primitives.vertex(primitiveAt(cluster, k), c));
      });
      boxes_[i] = bounds.finite ? boxAround(bounds.lower, bounds.upper) : Box{glm::vec4(0), glm::vec4(-1)};
    }
  });
  group(boxes_, groups_);
  group(groups_, largeGroups_);
  all_ = groupOf(largeGroups_, 0, largeGroups_.size());
}

Clusters::Box Clusters::groupOf(const Boxes& boxes, size_t first, size_t last) {
  Bounds4 bounds;
  for (size_t k = first; k < last; ++k) {
    const glm::dvec4 center(boxes[k].center), extent(boxes[k].extent);
    bounds.finite = bounds.finite && boxes[k].isFinite();
    bounds.add(center - extent), bounds.add(center + extent);
  }
  return bounds.finite ? boxAround(bounds.lower, bounds.upper) : Box{glm::vec4(0), glm::vec4(-1)};
}

void Clusters::group(const Boxes& boxes, Boxes& groups) {
  groups.resize((boxes.size() + kGroup - 1) / kGroup);
  forPieces(groups.size(), kClusterGrain, [&](size_t first, size_t last) {
    for (size_t i = first; i < last; ++i)
      groups[i] = groupOf(boxes, kGroup * i, std::min(kGroup * (i + 1), boxes.size()));
  });
}

Clusters::Box Clusters::boxAround(const glm::dvec4& lower, const glm::dvec4& upper) {
  Box box;
  box.center = glm::vec4(0.5 * (lower + upper));
  const glm::dvec4 middle(box.center);
  const glm::dvec4 extent = glm::max(upper - middle, middle - lower);
  box.extent = glm::vec4(extent * (1 + 1e-6)) + glm::vec4(std::numeric_limits<float>::min());
  return box;
}

/// Whether consecutive primitives of the draw spread much wider than the surface that they cover.
bool Clusters::areScattered(const Primitives& primitives) const {
  constexpr double kWide = 12;  // diagonals of a primitive; of 64 triangles in a square patch it is about 6
  constexpr size_t kSamples = 512;
  double runs = 0, single = 0;
  const size_t step = std::max<size_t>(1, groups_.size() / kSamples);
  for (size_t group = 0; group < groups_.size(); group += step) {
    if (!groups_[group].isFinite()) continue;
    Bounds4 bounds;
    const uint32_t primitive = primitiveAt(static_cast<uint32_t>(group * kGroup), 0);
    for (uint32_t c = 0; c < primitives.corners; ++c)
      bounds.add(primitives.position(primitives.vertex(primitive, c)));
    runs += 2 * glm::length(glm::dvec3(groups_[group].extent)), single += bounds.diagonal();
  }
  return runs > kWide * single;
}

/// Sorts primitives along a Morton curve through their centres.
void Clusters::sort(const Primitives& primitives) {
  Bounds4 all;
  for (const Box& box : boxes_)
    if (box.isFinite()) all.add(glm::dvec4(box.center));
  const glm::dvec3 lower(all.lower), size = glm::max(glm::dvec3(all.upper) - lower, glm::dvec3(1e-300));
  std::vector<std::pair<uint64_t, uint32_t>> keys(primitives.count);
  forPieces(keys.size(), kClusterGrain * kPrimitives, [&](size_t first, size_t last) {
    for (size_t i = first; i < last; ++i) {
      const glm::dvec3 at = (glm::dvec3(middleOf(primitives, static_cast<uint32_t>(i))) - lower) / size;
      uint64_t key = 0;
      for (int c = 0; c < 3; ++c) {
        const double clamped = at[c] > 0 ? std::min(at[c], 1.0) : 0.0;  // 0 where it is not a number
        key |= spread3(static_cast<uint64_t>(clamped * 0x1fffff)) << c;
      }
      keys[i] = {key, static_cast<uint32_t>(i)};
    }
  });
  sharedArena()->execute([&] { tbb::parallel_sort(keys.begin(), keys.end()); });
  numbers_.resize(keys.size());
  for (size_t i = 0; i < keys.size(); ++i) numbers_[i] = keys[i].second;
}

void Clusters::mayShow(const ClipMatrix& matrix, const WindowMapping& window, const DepthPyramid* pyramid,
                       std::vector<uint64_t>& visible) const {
  visible.assign(words(), 0);
  const BoxVisibility view(matrix, window, pyramid);
  forPieces(visible.size(), kClusterGrain / 64, [&](size_t first, size_t last) {
    for (size_t word = first; word < last; ++word) {
      const auto shows = [&](const Box& box) {
        return !box.isFinite() || view.mayShow(glm::dvec4(box.center), glm::dvec4(box.extent));
      };
      uint64_t bits = 0;
      static_assert(kGroup * kGroup == 64);  // a large group has a word
      const size_t end = shows(largeGroups_[word]) ? std::min(boxes_.size(), 64 * (word + 1)) : 0;
      for (size_t i = 64 * word; i < end; ++i) {
        if (i % kGroup == 0 && !shows(groups_[i / kGroup]))
          i += kGroup - 1;
        else if (shows(boxes_[i]))
          bits |= uint64_t{1} << (i & 63);
      }
      visible[word] = bits;
    }
  });
}

size_t Clusters::write(std::span<const uint64_t> visible, const Primitives& p, uint32_t* out) const {
  uint32_t* const start = out;
  const auto copy = [&](uint32_t first, uint32_t count) {
    const size_t corners = size_t{count} * p.corners, from = size_t{first} * p.corners;
    if (p.indices)
      std::memcpy(out, p.indices + from, corners * sizeof(uint32_t));
    else
      for (size_t i = 0; i < corners; ++i) out[i] = p.first + static_cast<uint32_t>(from + i);
    out += corners;
  };
  const auto each = [](std::span<const uint64_t> words, const auto& body) {
    for (size_t word = 0; word < words.size(); ++word)
      for (uint64_t bits = words[word]; bits != 0; bits &= bits - 1)
        body(static_cast<uint32_t>(64 * word) + static_cast<uint32_t>(std::countr_zero(bits)));
  };
  if (areRuns()) {
    each(visible, [&](uint32_t cluster) { copy(cluster * kPrimitives, primitivesOf(cluster)); });
    return static_cast<size_t>(out - start);
  }
  std::vector<uint64_t> drawn((primitives_ + 63) / 64, 0);
  each(visible, [&](uint32_t cluster) {
    for (uint32_t k = 0; k < primitivesOf(cluster); ++k) {
      const uint32_t primitive = primitiveAt(cluster, k);
      drawn[primitive / 64] |= uint64_t{1} << (primitive & 63);
    }
  });
  each(drawn, [&](uint32_t primitive) { copy(primitive, 1); });
  return static_cast<size_t>(out - start);
}

uint64_t Clusters::primitivesIn(std::span<const uint64_t> visible) const {
  uint64_t clusters = 0;
  for (const uint64_t word : visible) clusters += static_cast<uint64_t>(std::popcount(word));
  const uint32_t last = count() - 1;
  const bool hasLast = count() > 0 && last / 64 < visible.size() && (visible[last / 64] >> (last & 63) & 1);
  return clusters * kPrimitives - (hasLast ? kPrimitives - primitivesOf(last) : 0);
}

}  // namespace gluray::gl
