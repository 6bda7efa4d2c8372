#include "bench/data/png.h"

#include <png.h>

#include <algorithm>
#include <stdexcept>

namespace gluray::bench {
namespace {

png_image emptyImage() {
  png_image out{};
  out.version = PNG_IMAGE_VERSION;
  return out;
}

}  // namespace

RgbImage imageFromGl(int width, int height, const std::vector<uint8_t>& rgba) {
  RgbImage out{width, height, {}};
  out.rgb.reserve(size_t(width) * size_t(height) * 3);
  for (int y = height - 1; y >= 0; --y)
    for (int x = 0; x < width; ++x) {
      const uint8_t* pixel = rgba.data() + 4 * (size_t(y) * size_t(width) + size_t(x));
      out.rgb.insert(out.rgb.end(), pixel, pixel + 3);
    }
  return out;
}

RgbImage readPng(const std::string& path) {
  png_image image = emptyImage();
  if (!png_image_begin_read_from_file(&image, path.c_str()))
    throw std::runtime_error(path + ": " + image.message);
  image.format = PNG_FORMAT_RGB;
  RgbImage out{int(image.width), int(image.height), std::vector<uint8_t>(PNG_IMAGE_SIZE(image))};
  if (!png_image_finish_read(&image, nullptr, out.rgb.data(), 0, nullptr))
    throw std::runtime_error(path + ": " + image.message);
  return out;
}

void writePng(const RgbImage& source, const std::string& path) {
  png_image image = emptyImage();
  image.width = png_uint_32(source.width);
  image.height = png_uint_32(source.height);
  image.format = PNG_FORMAT_RGB;
  if (!png_image_write_to_file(&image, path.c_str(), 0, source.rgb.data(), 0, nullptr))
    throw std::runtime_error(path + ": " + image.message);
}

RgbImage sideBySide(const std::vector<RgbImage>& images, int gap) {
  RgbImage out;
  for (const RgbImage& source : images) {
    out.width += source.width + (out.width ? gap : 0);
    out.height = std::max(out.height, source.height);
  }
  out.rgb.assign(size_t(out.width) * size_t(out.height) * 3, 255);
  size_t left = 0;
  for (const RgbImage& source : images) {
    const size_t rowBytes = size_t(source.width) * 3;
    for (size_t y = 0; y < size_t(source.height); ++y)
      std::copy_n(source.rgb.data() + y * rowBytes, rowBytes,
                  out.rgb.data() + 3 * (y * size_t(out.width) + left));
    left += size_t(source.width + gap);
  }
  return out;
}

}  // namespace gluray::bench
