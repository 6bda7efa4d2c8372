#include "intercept/present/hit_bands.h"

#include <algorithm>
#include <cstddef>

namespace gluray::present {

std::vector<Band> hitBands(const float* depth, int width, int height) {
  constexpr int kLeastRows = 16;
  const int rows = std::max(kLeastRows, (height + kMaxBands - 1) / kMaxBands);
  std::vector<Band> bands;
  for (int y = 0; y < height; y += rows) {
    const int count = std::min(rows, height - y);
    int left = width, right = 0;
    for (int r = y; r < y + count; ++r) {
      const float* row = depth + static_cast<size_t>(r) * static_cast<size_t>(width);
      // Only what lies outside the band so far is looked at.
      for (int x = 0; x < left; ++x)
        if (row[x] <= 1.0f) left = x;
      for (int x = width; x > std::max(right, left); --x)
        if (row[x - 1] <= 1.0f) right = x;
    }
    if (left < right) bands.push_back({left, y, right - left, count});
  }
  return bands;
}

}  // namespace gluray::present
