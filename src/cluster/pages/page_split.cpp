#include "cluster/pages/page_split.h"

#include <tbb/blocked_range.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <memory>

namespace gluray::cluster {
namespace {

constexpr uint32_t kGrain = 1 << 14;
constexpr int kMaxBits = 8;             // of a cell's place along an axis
constexpr uint32_t kPerCell = 32;       // triangles, where they fill space evenly
constexpr float kFarthest = 1.844e18f;  // Embree takes no coordinates beyond

struct Box {
  glm::vec3 lower{INFINITY}, upper{-INFINITY};
  void add(const Box& other) { lower = glm::min(lower, other.lower), upper = glm::max(upper, other.upper); }
  bool isTraceable() const {
    for (int c = 0; c < 3; ++c)
      if (!(lower[c] > -kFarthest && upper[c] < kFarthest)) return false;
    return true;
  }
};

/// Of which no corner is finite or near enough: not isTraceable().
Box boxOf(const scene::Mesh& mesh, uint32_t triangle) {
  Box box;
  for (uint32_t k = 0; k < 3; ++k) {
    const glm::vec3 p = mesh.position(mesh.corner(triangle, k));
    if (!(std::abs(p.x) < kFarthest && std::abs(p.y) < kFarthest && std::abs(p.z) < kFarthest))
      return {glm::vec3(-INFINITY), glm::vec3(INFINITY)};
    box.add({p, p});
  }
  return box;
}

float longestSquared(const scene::Mesh& mesh, uint32_t triangle) {
  float squared = 0;
  for (uint32_t k = 0; k < 3; ++k) {
    const glm::vec3 edge =
        mesh.position(mesh.corner(triangle, (k + 1) % 3)) - mesh.position(mesh.corner(triangle, k));
    squared = std::max(squared, glm::dot(edge, edge));  // max keeps the first if the second is NaN
  }
  return squared;
}

/// The bits of x, with two zeros between them.
uint32_t spread(uint32_t x) {
  x = (x | x << 16) & 0x030000FF;
  x = (x | x << 8) & 0x0300F00F;
  x = (x | x << 4) & 0x030C30C3;
  return (x | x << 2) & 0x09249249;
}

class Grid {
 public:
  Grid(const Box& whole, uint64_t triangles)
      : bits_(std::clamp(static_cast<int>(std::bit_width(triangles / kPerCell) + 2) / 3, 1, kMaxBits)),
        lower_(whole.lower) {
    const float cells = static_cast<float>(1 << bits_);
    for (int c = 0; c < 3; ++c) {
      const float size = whole.upper[c] - whole.lower[c];
      perUnit_[c] = size > 0 && std::isfinite(cells / size) ? cells / size : 0;
    }
  }
  size_t cells() const { return size_t{1} << 3 * bits_; }
  /// Depends on the triangle's box alone. What cannot be traced is in the first one.
  uint32_t cellOf(const Box& box) const {
    if (!box.isTraceable()) return 0;
    uint32_t cell = 0;
    for (int c = 0; c < 3; ++c) {
      const float at = (0.5f * (box.lower[c] + box.upper[c]) - lower_[c]) * perUnit_[c];
      const auto last = static_cast<float>((1 << bits_) - 1);
      cell |= spread(static_cast<uint32_t>(std::clamp(at, 0.0f, last))) << c;
    }
    return cell;
  }

 private:
  const int bits_;
  const glm::vec3 lower_;
  glm::vec3 perUnit_{0};
};

/// Calls f(triangle) for all, on all threads.
template <class F>
void eachTriangle(const scene::Mesh& mesh, const F& f) {
  tbb::parallel_for(tbb::blocked_range<uint32_t>(0, mesh.triangleCount, kGrain),
                    [&](const tbb::blocked_range<uint32_t>& range) {
                      for (uint32_t t = range.begin(); t != range.end(); ++t) f(t);
                    });
}

struct Extent {
  Box box;
  float longest = 0;  // squared
};

Extent extentOf(const scene::Mesh& mesh) {
  tbb::combinable<Extent> parts;
  eachTriangle(mesh, [&](uint32_t t) {
    Extent& part = parts.local();
    if (const Box box = boxOf(mesh, t); box.isTraceable()) part.box.add(box);
    part.longest = std::max(part.longest, longestSquared(mesh, t));
  });
  return parts.combine([](Extent a, const Extent& b) {
    a.box.add(b.box);
    a.longest = std::max(a.longest, b.longest);
    return a;
  });
}

/// Where each cell's triangles begin, and after them the number of all.
std::vector<uint32_t> sortIntoCells(const scene::Mesh& mesh, const Grid& grid,
                                    std::vector<uint32_t>& triangles) {
  const auto ends = std::make_unique<std::atomic<uint32_t>[]>(grid.cells() + 1);
  eachTriangle(
      mesh, [&](uint32_t t) { ends[grid.cellOf(boxOf(mesh, t))].fetch_add(1, std::memory_order_relaxed); });
  std::vector<uint32_t> begins(grid.cells() + 1);
  for (size_t cell = 0; cell < grid.cells(); ++cell) {
    begins[cell + 1] = begins[cell] + ends[cell];
    ends[cell] = begins[cell];
  }
  triangles.resize(mesh.triangleCount);
  eachTriangle(mesh, [&](uint32_t t) {
    triangles[ends[grid.cellOf(boxOf(mesh, t))].fetch_add(1, std::memory_order_relaxed)] = t;
  });
  return begins;
}

std::vector<PageRange> pagesOf(const std::vector<uint32_t>& begins, uint32_t most,
                               std::vector<uint32_t>& triangles) {
  std::vector<PageRange> pages;
  PageRange open;
  const auto close = [&] {
    if (open.count > 0) pages.push_back(open);
    open = PageRange();
  };
  for (size_t cell = 0; cell + 1 < begins.size(); ++cell) {
    const uint32_t count = begins[cell + 1] - begins[cell];
    if (count == 0) continue;
    if (open.count + count > most) close();
    if (open.count == 0) open.first = begins[cell];
    open.count += count;
    if (count <= most) continue;
    std::sort(triangles.begin() + begins[cell], triangles.begin() + begins[cell + 1]);
    for (uint32_t left = count; left > 0;) {
      const uint32_t part = std::min(left, most);
      pages.push_back({begins[cell + 1] - left, part, 0, glm::vec3(1), glm::vec3(0)});
      left -= part;
    }
    open = PageRange();
  }
  close();
  return pages;
}

void complete(const scene::Mesh& mesh, std::vector<uint32_t>& triangles, PageRange& page) {
  const auto first = triangles.begin() + static_cast<ptrdiff_t>(page.first), end = first + page.count;
  std::sort(first, end);
  Box box;
  VertexNumbers numbers(page.count);
  for (auto t = first; t != end; ++t) {
    if (const Box one = boxOf(mesh, *t); one.isTraceable()) box.add(one);
    for (uint32_t k = 0; k < 3 && mesh.indices; ++k) numbers.numberOf(mesh.corner(*t, k));
  }
  page.vertices = mesh.indices ? static_cast<uint32_t>(numbers.vertices().size()) : 3 * page.count;
  if (box.lower.x <= box.upper.x) page.lower = box.lower, page.upper = box.upper;
}

}  // namespace

PageTable cutIntoPages(const scene::Mesh& mesh, uint32_t most) {
  PageTable table;
  const Extent extent = extentOf(mesh);
  table.whole = {extent.box.lower, extent.box.upper, std::sqrt(extent.longest)};
  const Grid grid(extent.box, mesh.triangleCount);
  const std::vector<uint32_t> begins = sortIntoCells(mesh, grid, table.triangles);
  table.pages = pagesOf(begins, most, table.triangles);
  tbb::parallel_for(size_t{0}, table.pages.size(),
                    [&](size_t i) { complete(mesh, table.triangles, table.pages[i]); });
  std::erase_if(table.pages, [](const PageRange& page) { return page.lower.x > page.upper.x; });
  return table;
}

VertexNumbers::VertexNumbers(uint32_t triangles)
    : slots_(std::bit_ceil(std::max<size_t>(size_t{6} * triangles, 8))) {
  vertices_.reserve(triangles);
}

uint32_t VertexNumbers::numberOf(uint32_t vertex) {
  const size_t mask = slots_.size() - 1;
  for (size_t at = vertex * size_t{0x9E3779B1} & mask;; at = (at + 1) & mask) {
    Slot& slot = slots_[at];
    if (slot.number == kNone) {
      slot = {vertex, static_cast<uint32_t>(vertices_.size())};
      vertices_.push_back(vertex);
      return slot.number;
    }
    if (slot.vertex == vertex) return slot.number;
  }
}

}  // namespace gluray::cluster
