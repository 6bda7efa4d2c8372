// Which parts of a traced picture hold anything: the write-back uploads and draws these alone.
#pragma once
#include <vector>

namespace gluray::frame {

/// Rows [y, y + height) of a picture, of which only columns [x, x + width) hold hits.
struct Band {
  int x = 0, y = 0, width = 0, height = 0;
  bool operator==(const Band&) const = default;
};

inline constexpr int kMaxBands = 32;
/// Rows of a band, all but the last, in a picture of that height.
int rowsOfBands(int height);
/// The band that begins at row `y`, a multiple of those: without columns where nothing in it was hit.
Band hitBand(const float* depth, int width, int height, int y);
/// At most `kMaxBands` bands, lowest first, that cover every pixel of `depth` (width*height window depths)
/// that was hit, that is, whose depth is at most 1. Bands without hits are left out.
std::vector<Band> hitBands(const float* depth, int width, int height);

}  // namespace gluray::frame
