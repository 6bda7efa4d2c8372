#include "gl/culled/clusters/depth_pyramid.h"

#include "parallel/arena.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>

namespace gluray::gl {
namespace {

constexpr int kFirstShift = 1, kFirst = 1 << kFirstShift;
constexpr int kMaxValues = 5;  // maximum values along each axis that farthest() reads

int halved(int size) { return (size + 1) / 2; }

/// Computes one row of the first level from `rows` rows of pixels.
void reduceRow(const float* depths, int width, int rows, float* out) {
  const auto stride = static_cast<size_t>(width);
  for (int x = 0; x < width; x += kFirst) {
    const int columns = std::min(kFirst, width - x);
    float most = 0;
    for (int row = 0; row < rows; ++row)
      for (int c = 0; c < columns; ++c) {
        const float depth = depths[static_cast<size_t>(row) * stride + static_cast<size_t>(x + c)];
        most = std::max(most, depth);
      }
    out[x / kFirst] = most;
  }
}

}  // namespace

void DepthPyramid::build(const float* depths, int width, int height) {
  width_ = width, height_ = height;
  int levels = 1;
  for (int size = std::max(width, height) / kFirst; size > 1; size = halved(size)) ++levels;
  levels_.resize(static_cast<size_t>(levels));
  Level& first = levels_[0];
  first.width = (width + kFirst - 1) / kFirst, first.height = (height + kFirst - 1) / kFirst;
  first.farthest.resize(static_cast<size_t>(first.width) * static_cast<size_t>(first.height));
  sharedArena()->execute([&] {
    tbb::parallel_for(tbb::blocked_range<int>(0, first.height, 16), [&](const tbb::blocked_range<int>& rows) {
      for (int y = rows.begin(); y < rows.end(); ++y)
        reduceRow(depths + static_cast<size_t>(y) * kFirst * static_cast<size_t>(width), width,
                  std::min(kFirst, height - y * kFirst),
                  first.farthest.data() + static_cast<size_t>(y) * static_cast<size_t>(first.width));
    });
  });
  for (size_t l = 1; l < levels_.size(); ++l) {
    const Level& below = levels_[l - 1];
    Level& level = levels_[l];
    level.width = halved(below.width), level.height = halved(below.height);
    level.farthest.resize(static_cast<size_t>(level.width) * static_cast<size_t>(level.height));
    const auto at = [&](int x, int y) {
      const int cx = std::min(x, below.width - 1), cy = std::min(y, below.height - 1);
      return below
          .farthest[static_cast<size_t>(cy) * static_cast<size_t>(below.width) + static_cast<size_t>(cx)];
    };
    for (int y = 0; y < level.height; ++y)
      for (int x = 0; x < level.width; ++x)
        level.farthest[static_cast<size_t>(y) * static_cast<size_t>(level.width) + static_cast<size_t>(x)] =
            std::max(std::max(at(2 * x, 2 * y), at(2 * x + 1, 2 * y)),
                     std::max(at(2 * x, 2 * y + 1), at(2 * x + 1, 2 * y + 1)));
  }
}

float DepthPyramid::farthest(int x0, int y0, int x1, int y1) const {
  x0 = std::clamp(x0, 0, width_ - 1), x1 = std::clamp(x1, x0, width_ - 1);
  y0 = std::clamp(y0, 0, height_ - 1), y1 = std::clamp(y1, y0, height_ - 1);
  int shift = kFirstShift;
  size_t l = 0;
  while (l + 1 < levels_.size() &&
         ((x1 >> shift) - (x0 >> shift) >= kMaxValues || (y1 >> shift) - (y0 >> shift) >= kMaxValues))
    ++shift, ++l;
  const Level& level = levels_[l];
  float most = 0;
  for (int y = y0 >> shift; y <= y1 >> shift; ++y)
    for (int x = x0 >> shift; x <= x1 >> shift; ++x)
      most = std::max(
          most,
          level.farthest[static_cast<size_t>(y) * static_cast<size_t>(level.width) + static_cast<size_t>(x)]);
  return most;
}

}  // namespace gluray::gl
