#include "control/link/program/kept_picture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gluray::control {
namespace {

/// Rows of a picture, the top one first.
class PictureRows {
 public:
  explicit PictureRows(const KeptPicture& picture) : picture_(picture) {}
  const uint32_t* operator[](int y) const {
    const int row = picture_.layout == KeptPicture::Layout::x ? y : picture_.height - 1 - y;
    return picture_.pixels.data() + static_cast<size_t>(row) * static_cast<size_t>(picture_.width);
  }
  /// Shifts of red, green and blue in a pixel.
  std::array<int, 3> shifts() const {
    return picture_.layout == KeptPicture::Layout::x ? std::array{16, 8, 0} : std::array{0, 8, 16};
  }

 private:
  const KeptPicture& picture_;
};

/// Where the part `i` of `parts` equal ones begins.
int beginOf(int i, int parts, int all) { return static_cast<int>(static_cast<int64_t>(i) * all / parts); }

RgbPicture averaged(const KeptPicture& picture, int width, int height) {
  RgbPicture out{width, height, {}};
  out.bytes.reserve(3 * static_cast<size_t>(width) * static_cast<size_t>(height));
  const PictureRows rows(picture);
  const std::array<int, 3> shifts = rows.shifts();
  std::vector<uint64_t> sums(3 * static_cast<size_t>(width));
  for (int y = 0; y < height; ++y) {
    const int top = beginOf(y, height, picture.height), end = beginOf(y + 1, height, picture.height);
    std::fill(sums.begin(), sums.end(), 0);
    for (int row = top; row < end; ++row)
      for (int x = 0; x < width; ++x)
        for (int at = beginOf(x, width, picture.width); at < beginOf(x + 1, width, picture.width); ++at)
          for (size_t c = 0; c < 3; ++c)
            sums[3 * static_cast<size_t>(x) + c] += rows[row][at] >> shifts[c] & 255;
    for (int x = 0; x < width; ++x) {
      const int columns = beginOf(x + 1, width, picture.width) - beginOf(x, width, picture.width);
      const auto count = static_cast<uint64_t>(columns) * static_cast<uint64_t>(end - top);
      for (size_t c = 0; c < 3; ++c)
        out.bytes += static_cast<char>((sums[3 * static_cast<size_t>(x) + c] + count / 2) / count);
    }
  }
  return out;
}

bool isWhole(const KeptPicture& picture) {
  return picture.width > 0 && picture.height > 0 &&
         picture.pixels.size() == static_cast<size_t>(picture.width) * static_cast<size_t>(picture.height);
}

}  // namespace

RgbPicture rgbOf(const KeptPicture& picture) {
  return isWhole(picture) ? averaged(picture, picture.width, picture.height) : RgbPicture{};
}

RgbPicture scaledDown(const KeptPicture& picture, int longest, int64_t mostPixels) {
  if (!isWhole(picture)) return {};
  const double width = picture.width, height = picture.height;
  double scale = std::min(1.0, longest / std::max(width, height));
  scale = std::min(scale, std::sqrt(static_cast<double>(mostPixels) / (width * height)));
  const auto scaled = [&](double side) { return std::max(1, static_cast<int>(side * scale + 1e-9)); };
  return averaged(picture, scaled(width), scaled(height));
}

}  // namespace gluray::control
