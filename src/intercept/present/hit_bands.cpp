#include "intercept/present/hit_bands.h"

#include <algorithm>
#include <cstddef>

namespace gluray::present {
namespace {

constexpr int kBlock = 16;  // pixels looked at together

bool anyHit(const float* depth) {
  int hits = 0;
  for (int i = 0; i < kBlock; ++i) hits |= depth[i] <= 1.0f;
  return hits != 0;
}

/// Column of the first hit left of `limit`, or `limit`.
int firstHit(const float* row, int limit) {
  int x = 0;
  while (x + kBlock <= limit && !anyHit(row + x)) x += kBlock;
  while (x < limit && !(row[x] <= 1.0f)) ++x;
  return x;
}

/// One past the column of the last hit from `limit` on, or `limit`.
int lastHit(const float* row, int limit, int width) {
  int x = width;
  while (x - kBlock >= limit && !anyHit(row + x - kBlock)) x -= kBlock;
  while (x > limit && !(row[x - 1] <= 1.0f)) --x;
  return x;
}

}  // namespace

int rowsOfBands(int height) {
  constexpr int kLeastRows = 16;
  return std::max(kLeastRows, (height + kMaxBands - 1) / kMaxBands);
}

Band hitBand(const float* depth, int width, int height, int y) {
  const int count = std::min(rowsOfBands(height), height - y);
  int left = width, right = 0;
  for (int r = y; r < y + count; ++r) {
    const float* row = depth + static_cast<size_t>(r) * static_cast<size_t>(width);
    // Only what lies outside the band so far is looked at.
    left = firstHit(row, left);
    const int known = std::max(right, left), last = lastHit(row, known, width);
    if (last > known) right = last;
  }
  return {left, y, std::max(right - left, 0), count};
}

std::vector<Band> hitBands(const float* depth, int width, int height) {
  std::vector<Band> bands;
  for (int y = 0; y < height; y += rowsOfBands(height)) {
    const Band band = hitBand(depth, width, height, y);
    if (band.width > 0) bands.push_back(band);
  }
  return bands;
}

}  // namespace gluray::present
