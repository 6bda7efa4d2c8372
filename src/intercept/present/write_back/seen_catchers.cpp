#include "intercept/present/write_back/seen_catchers.h"

#include "parallel/loops.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace gluray::present {
namespace {

/// How far the framebuffer's depth may be from an image's.
struct DepthReach {
  float perSlope, behind, before;  // behind: perSlope * (depth step to a neighbour) + behind
};

DepthReach reachOf(const scene::PolygonOffset& offset) {
  constexpr float kHalfPixel = 0.5f, kFloatUnit = 1.0f / (1 << 23);
  const float unit = offset.floats ? kFloatUnit : offset.resolution;
  return {2 * std::abs(offset.factor) + kHalfPixel, 2 * std::abs(offset.units) * unit, 0.5f * unit};
}

/// The depths about a row of an image; at its border, the row itself stands for the one outside.
struct DepthRows {
  const float *below, *row, *above;
  DepthRows(const Image& image, size_t y) {
    const auto width = static_cast<size_t>(image.width);
    row = image.depth.data() + y * width;
    below = y > 0 ? row - width : row;
    above = y + 1 < static_cast<size_t>(image.height) ? row + width : row;
  }
};

/// The depth step to a neighbour; 0 where that shows no surface.
inline float stepTo(float neighbour, float depth) {
  return neighbour == Image::kMiss ? 0 : std::abs(neighbour - depth);
}

/// Of each pixel in a row, the largest depth step to its four neighbours. At folds the smallest one may be
/// that of the other side.
void findSlopes(const DepthRows& rows, size_t width, float* __restrict slopes) {
  const float *row = rows.row, *below = rows.below, *above = rows.above;
  for (size_t x = 0; x < width; ++x) slopes[x] = std::max(stepTo(below[x], row[x]), stepTo(above[x], row[x]));
  for (size_t x = 1; x < width; ++x) slopes[x] = std::max(slopes[x], stepTo(row[x - 1], row[x]));
  for (size_t x = 0; x + 1 < width; ++x) slopes[x] = std::max(slopes[x], stepTo(row[x + 1], row[x]));
}

/// Calls put(y, rows, slopes) for each row of an image, on all threads.
template <class Put>
void eachRow(const Image& image, const Put& put) {
  constexpr size_t kPieceRows = 32;
  const auto width = static_cast<size_t>(image.width);
  forPieces(static_cast<size_t>(image.height), kPieceRows, [&](size_t first, size_t last) {
    std::vector<float> slopes(width);
    for (size_t y = first; y < last; ++y) {
      const DepthRows rows(image, y);
      findSlopes(rows, width, slopes.data());
      put(y, rows, slopes.data());
    }
  });
}

/// Opacities of a row's visible pixels.
void takeRow(const float* depth, const float* slopes, const float* there, const uint32_t* color,
             DepthReach reach, size_t width, uint8_t* __restrict out) {
  for (size_t x = 0; x < width; ++x) {
    const float farthest = depth[x] + reach.perSlope * slopes[x] + reach.behind;
    const bool seen =
        (there[x] <= farthest) & (depth[x] <= there[x] + reach.before) & (depth[x] != Image::kMiss);
    out[x] = static_cast<uint8_t>(seen ? color[x] >> 24 : 0u);
  }
}

}  // namespace

void findSeenCatchers(const Image& image, const scene::Snapshot& snapshot, const std::vector<float>& depths,
                      Image& seen) {
  const DepthReach reach = reachOf(snapshot.polygonOffset);
  const auto width = static_cast<size_t>(image.width);
  seen = image;
  eachRow(image, [&](size_t y, const DepthRows& rows, const float* slopes) {
    const float* there = depths.data() + y * width;
    float* out = seen.depth.data() + y * width;
    for (size_t x = 0; x < width; ++x) {
      const float farthest = rows.row[x] + reach.perSlope * slopes[x] + reach.behind;
      out[x] = there[x] <= farthest ? rows.row[x] : Image::kMiss;
    }
  });
}

void findTakenLight(const Image& image, const scene::Snapshot& snapshot, const std::vector<float>& depths,
                    TakenLight& taken) {
  const DepthReach reach = reachOf(snapshot.polygonOffset);
  const auto width = static_cast<size_t>(image.width);
  taken.x = image.x, taken.y = image.y;
  taken.resize(image.width, image.height);
  taken.bands = frame::hitBands(image.depth.data(), image.width, image.height);
  eachRow(image, [&](size_t y, const DepthRows& rows, const float* slopes) {
    takeRow(rows.row, slopes, depths.data() + y * width, image.color.data() + y * width, reach, width,
            taken.opacity.data() + y * static_cast<size_t>(taken.rowBytes));
  });
}

}  // namespace gluray::present
