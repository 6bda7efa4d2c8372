#include "intercept/present/write_back/seen_catchers.h"

#include "parallel/loops.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace gluray::present {
namespace {

/// The larger depth step from a pixel to its two neighbours along one axis; 0 where neither shows a surface.
/// At folds the smaller one may be that of the other side.
float stepAlong(const Image& image, size_t pixel, bool before, bool after, size_t stride) {
  float step = 0;
  const auto look = [&](size_t other) {
    if (image.depth[other] != Image::kMiss)
      step = std::max(step, std::abs(image.depth[other] - image.depth[pixel]));
  };
  if (before) look(pixel - stride);
  if (after) look(pixel + stride);
  return step;
}

}  // namespace

void findSeenCatchers(const Image& image, const scene::Snapshot& snapshot, const std::vector<float>& depths,
                      Image& seen) {
  constexpr float kHalfPixel = 0.5f, kFloatUnit = 1.0f / (1 << 23);
  constexpr size_t kRows = 32;  // of a piece
  const scene::PolygonOffset& offset = snapshot.polygonOffset;
  const float unit = offset.floats ? kFloatUnit : offset.resolution;
  seen = image;
  const auto width = static_cast<size_t>(image.width), height = static_cast<size_t>(image.height);
  const auto look = [&](size_t x, size_t y) {
    const size_t i = y * width + x;
    if (image.depth[i] == Image::kMiss) return;
    const float slope = std::max(stepAlong(image, i, x > 0, x + 1 < width, 1),
                                 stepAlong(image, i, y > 0, y + 1 < height, width));
    const float behind = 2 * (std::abs(offset.factor) * slope + std::abs(offset.units) * unit);
    if (!(depths[i] <= image.depth[i] + behind + kHalfPixel * slope)) seen.depth[i] = Image::kMiss;
  };
  forPieces(height, kRows, [&](size_t first, size_t last) {
    for (size_t y = first; y < last; ++y)
      for (size_t x = 0; x < width; ++x) look(x, y);
  });
}

}  // namespace gluray::present
