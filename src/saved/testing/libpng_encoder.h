// PNG files by libpng, for tests.
#pragma once
#include "saved/export/arrays/png_encoder.h"

#include <png.h>

#include <stdexcept>
#include <string>

namespace gluray::saved::test {

inline std::string encodePng(const PngPixels& pixels) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(pixels.width),
  image.height = static_cast<png_uint_32>(pixels.height);
  image.format = pixels.alpha ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string out(size, '\0');
  if (!png_image_write_to_memory(&image, out.data(), &size, 0, pixels.bytes.data(), 0, nullptr))
    throw std::runtime_error(image.message);
  out.resize(size);
  return out;
}

}  // namespace gluray::saved::test
