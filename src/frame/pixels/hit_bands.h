// Bands of a traced image that contain hits: the write-back uploads and draws only these. Any thread.
#pragma once
#include <vector>

namespace gluray::frame {

/// Rows [y, y + height) of an image; columns outside [x, x + width) hold no hits.
struct Band {
  int x = 0, y = 0, width = 0, height = 0;
  bool operator==(const Band&) const = default;
};

inline constexpr int kMaxBands = 32;
/// Rows per band in an image of this height; the last band may have fewer.
int rowsOfBands(int height);
/// The band that starts at row `y`, a multiple of rowsOfBands(). Its width is 0 if it holds no hits.
Band hitBand(const float* depth, int width, int height, int y);
/// At most `kMaxBands` bands, bottom first, that cover every hit of `depth` (width*height window depths; hits
/// are at most 1). Bands without hits are left out.
std::vector<Band> hitBands(const float* depth, int width, int height);

}  // namespace gluray::frame
