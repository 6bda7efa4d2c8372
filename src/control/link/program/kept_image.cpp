#include "control/link/program/kept_image.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gluray::control {
namespace {

/// Accesses the rows of an image, the top one first.
class ImageRows {
 public:
  explicit ImageRows(const KeptImage& image) : image_(image) {}
  const uint32_t* operator[](int y) const {
    const int row = image_.layout == KeptImage::Layout::x ? y : image_.height - 1 - y;
    return image_.pixels.data() + static_cast<size_t>(row) * static_cast<size_t>(image_.width);
  }
  /// Bit positions of red, green and blue in a pixel.
  std::array<int, 3> shifts() const {
    return image_.layout == KeptImage::Layout::x ? std::array{16, 8, 0} : std::array{0, 8, 16};
  }

 private:
  const KeptImage& image_;
};

/// Start of part `i` if `all` is divided into `parts` equal parts.
int beginOf(int i, int parts, int all) { return static_cast<int>(static_cast<int64_t>(i) * all / parts); }

RgbImage averaged(const KeptImage& image, int width, int height) {
  RgbImage out{width, height, {}};
  out.bytes.reserve(3 * static_cast<size_t>(width) * static_cast<size_t>(height));
  const ImageRows rows(image);
  const std::array<int, 3> shifts = rows.shifts();
  std::vector<uint64_t> sums(3 * static_cast<size_t>(width));
  for (int y = 0; y < height; ++y) {
    const int top = beginOf(y, height, image.height), end = beginOf(y + 1, height, image.height);
    std::fill(sums.begin(), sums.end(), 0);
    for (int row = top; row < end; ++row)
      for (int x = 0; x < width; ++x)
        for (int at = beginOf(x, width, image.width); at < beginOf(x + 1, width, image.width); ++at)
          for (size_t c = 0; c < 3; ++c)
            sums[3 * static_cast<size_t>(x) + c] += rows[row][at] >> shifts[c] & 255;
    for (int x = 0; x < width; ++x) {
      const int columns = beginOf(x + 1, width, image.width) - beginOf(x, width, image.width);
      const auto count = static_cast<uint64_t>(columns) * static_cast<uint64_t>(end - top);
      for (size_t c = 0; c < 3; ++c)
        out.bytes += static_cast<char>((sums[3 * static_cast<size_t>(x) + c] + count / 2) / count);
    }
  }
  return out;
}

bool isWhole(const KeptImage& image) {
  return image.width > 0 && image.height > 0 &&
         image.pixels.size() == static_cast<size_t>(image.width) * static_cast<size_t>(image.height);
}

}  // namespace

RgbImage rgbOf(const KeptImage& image) {
  return isWhole(image) ? averaged(image, image.width, image.height) : RgbImage{};
}

RgbImage scaledDown(const KeptImage& image, int longest, int64_t mostPixels) {
  if (!isWhole(image)) return {};
  const double width = image.width, height = image.height;
  double scale = std::min(1.0, longest / std::max(width, height));
  scale = std::min(scale, std::sqrt(static_cast<double>(mostPixels) / (width * height)));
  const auto scaled = [&](double side) { return std::max(1, static_cast<int>(side * scale + 1e-9)); };
  return averaged(image, scaled(width), scaled(height));
}

}  // namespace gluray::control
