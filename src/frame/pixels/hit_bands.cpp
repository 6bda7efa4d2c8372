#include "frame/pixels/hit_bands.h"

#include "frame/pixels/pixel_rows.h"

#include <algorithm>
#include <cstddef>

namespace gluray::frame {

int rowsOfBands(int height) {
  constexpr int kMinRows = 16;
  return std::max(kMinRows, (height + kMaxBands - 1) / kMaxBands);
}

Band hitBand(const float* depth, int width, int height, int y) {
  const int count = std::min(rowsOfBands(height), height - y);
  int left = width, right = 0;
  for (int r = y; r < y + count; ++r) {
    const float* row = depth + static_cast<size_t>(r) * static_cast<size_t>(width);
    // Searches only columns outside the band so far.
    left = static_cast<int>(firstHit(row, static_cast<size_t>(left)));
    const int known = std::max(right, left);
    const auto last = static_cast<int>(endOfHits(row + known, static_cast<size_t>(width - known)));
    if (last > 0) right = known + last;
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

}  // namespace gluray::frame
