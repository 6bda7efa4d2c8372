#include "render/edges/grown_triangles.h"

#include "render/edges/edged_triangle.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <array>
#include <atomic>
#include <optional>
#include <utility>

namespace gluray::render {
namespace {

constexpr uint32_t kGrain = 4096;  // triangles

/// An interval of window coordinates; empty if the ends are in the wrong order.
struct Interval {
  double lower, upper;
};

/// The part of a row that lies in all of the half planes, moved outwards by `margin`.
Interval across(std::span<const HalfPlane> planes, double y, double margin) {
  Interval part{-HUGE_VAL, HUGE_VAL};
  for (const HalfPlane& plane : planes) {
    const double rest = plane.least - margin - plane.normal.y * y;
    if (plane.normal.x > 0)
      part.lower = std::max(part.lower, rest / plane.normal.x);
    else if (plane.normal.x < 0)
      part.upper = std::min(part.upper, rest / plane.normal.x);
    else if (rest > 0)
      return {HUGE_VAL, -HUGE_VAL};
  }
  return part;
}

/// Pixels, exclusive end.
struct Range {
  int first, last;
};

/// Those of [first, last) whose samples at `offset` lie in the interval.
Range pixelsIn(const Interval& part, double offset, int first, int last) {
  const double from = std::ceil(part.lower - offset), to = std::floor(part.upper - offset) + 1;
  return {from > first ? static_cast<int>(std::min<double>(from, last)) : first,
          to < last ? static_cast<int>(std::max<double>(to, first)) : last};
}

/// Largest distance of a sample from its pixel's centre, along one axis.
double reachOf(const std::vector<glm::dvec2>& positions) {
  double reach = 0;
  for (const glm::dvec2& p : positions) reach = std::max({reach, std::abs(p.x - 0.5), std::abs(p.y - 0.5)});
  return reach;
}

/// Calls test(x, y) for each pixel of the tile whose sample at `offset` may lie in the grown triangle, but
/// not in the triangle as it was.
template <class Test>
void eachGrown(const EdgedTriangle& triangle, const Tile& tile, const glm::dvec2& offset, Test&& test) {
  constexpr double kRounding = 1e-3;  // pixels
  const std::array grown = triangle.grown();
  const std::array own = triangle.own();
  const WindowBox box = triangle.bounds();
  const glm::dvec2 lower = box.lower - kRounding, upper = box.upper + kRounding;
  const Range rows = pixelsIn({lower.y, upper.y}, offset.y, tile.y0, tile.y1);
  for (int y = rows.first; y < rows.last; ++y) {
    Interval outer = across(grown, y + offset.y, kRounding);
    outer = {std::max(outer.lower, lower.x), std::min(outer.upper, upper.x)};
    const Range all = pixelsIn(outer, offset.x, tile.x0, tile.x1);
    if (all.first >= all.last) continue;
    const Range inner = pixelsIn(across(own, y + offset.y, -kRounding), offset.x, all.first, all.last);
    const bool some = inner.first < inner.last;
    for (int x = all.first; x < (some ? inner.first : all.last); ++x) test(x, y);
    for (int x = some ? inner.last : all.last; x < all.last; ++x) test(x, y);
  }
}

}  // namespace

bool growsByEdges(const Surface& surface) {
  if (!surface.lighting) return false;
  const scene::FragmentShading& f = surface.lighting->shading->fragment;
  return f.edges && f.edgesGrow;
}

/// Calls visit(square, triangle) for all squares that triangles may touch, on all cores.
template <class Visit>
void GrownTriangles::eachSquare(Visit&& visit) const {
  const scene::Snapshot& s = stage_.snapshot;
  const glm::dvec2 origin(s.region.x, s.region.y), last(across_ - 1, down_ - 1);
  const double reach = reachOf(stage_.samplePositions);
  for (uint32_t i = 0; i < stage_.surfaces.size(); ++i) {
    const Surface& surface = stage_.surfaces[i];
    if (!growsByEdges(surface)) continue;
    const double margin = 0.25 * surface.lighting->shading->fragment.edgeWidth + reach + 0.5;
    const tbb::blocked_range<uint32_t> all(0, surface.mesh->triangleCount, kGrain);
    tbb::parallel_for(all, [&](const tbb::blocked_range<uint32_t>& part) {
      for (uint32_t t = part.begin(); t < part.end(); ++t) {
        const std::optional<WindowBox> box = windowBoxOf(surface, s.camera, t);
        if (!box) continue;
        const glm::dvec2 from = glm::floor((box->lower - margin - origin) / double{kTileSize}),
                         to = glm::floor((box->upper + margin - origin) / double{kTileSize});
        if (!(to.x >= 0 && to.y >= 0 && from.x <= last.x && from.y <= last.y)) continue;
        const glm::ivec2 a(glm::max(from, 0.0)), b(glm::min(to, last));
        for (int y = a.y; y <= b.y; ++y)
          for (int x = a.x; x <= b.x; ++x) visit(static_cast<size_t>(y * across_ + x), Triangle{i, t});
      }
    });
  }
}

GrownTriangles::GrownTriangles(const GrowthStage& stage)
    : stage_(stage),
      across_((stage.width + kTileSize - 1) / kTileSize),
      down_((stage.height + kTileSize - 1) / kTileSize),
      begins_(static_cast<size_t>(across_) * static_cast<size_t>(down_) + 1) {
  eachSquare([&](size_t square, const Triangle&) {
    std::atomic_ref(begins_[square]).fetch_add(1, std::memory_order_relaxed);
  });
  uint32_t sum = 0;
  for (uint32_t& begin : begins_) begin = std::exchange(sum, sum + begin);
  triangles_.resize(sum);
  std::vector<uint32_t> next(begins_.begin(), begins_.end() - 1);
  eachSquare([&](size_t square, const Triangle& triangle) {
    triangles_[std::atomic_ref(next[square]).fetch_add(1, std::memory_order_relaxed)] = triangle;
  });
}

void GrownTriangles::tryTriangle(const Triangle& t, const Tile& tile, const glm::dvec2& shift,
                                 std::span<Nearest> pixels) const {
  const Surface& surface = stage_.surfaces[t.instance];
  const EdgedTriangle triangle(surface, stage_.snapshot.camera, t.primitive);
  eachGrown(triangle, tile, shift, [&](int x, int y) {
    const glm::dvec2 at = glm::dvec2(x, y) + shift;
    if (!triangle.covers(at)) return;
    const double ndc = triangle.ndcDepth(at);
    if (!(std::abs(ndc) <= 1)) return;  // cut off by the near or the far plane
    Nearest& best = pixels[static_cast<size_t>((y - tile.y0) * (tile.x1 - tile.x0) + x - tile.x0)];
    const Nearest next{stage_.depth.windowDepth(ndc), t.instance, t.primitive};
    if (!isSeenBefore(stage_.snapshot, next, best)) return;
    const glm::vec2 weights = triangle.weights(at);
    if (stage_.accepted && !stage_.accepted->accepts(t.instance, t.primitive, weights.x, weights.y, 0))
      return;
    best = next;
  });
}

void GrownTriangles::findNearest(int sample, const Tile& tile, std::span<Nearest> pixels) const {
  std::fill(pixels.begin(), pixels.end(), Nearest{});
  const scene::Region& region = stage_.snapshot.region;
  const glm::dvec2 shift =
      stage_.samplePositions[static_cast<size_t>(sample)] + glm::dvec2(region.x, region.y);
  for (int y = tile.y0 / kTileSize; y * kTileSize < tile.y1; ++y)
    for (int x = tile.x0 / kTileSize; x * kTileSize < tile.x1; ++x) {
      const auto square = static_cast<size_t>(y * across_ + x);
      for (uint32_t t = begins_[square]; t < begins_[square + 1]; ++t)
        tryTriangle(triangles_[t], tile, shift, pixels);
    }
}

GrownSamples::GrownSamples(const GrownTriangles* triangles, const Tile& tile, int samples)
    : triangles_(triangles),
      tile_(tile),
      samples_(samples),
      width_(static_cast<size_t>(tile.x1 - tile.x0)),
      perSample_(width_ * static_cast<size_t>(tile.y1 - tile.y0)),
      pixels_(triangles ? static_cast<size_t>(samples) * perSample_ : 0) {}

void GrownSamples::find(int sample) {
  if (triangles_)
    triangles_->findNearest(sample, tile_, std::span(pixels_).subspan(slot(sample), perSample_));
}

}  // namespace gluray::render
