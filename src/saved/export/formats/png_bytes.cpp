#include "saved/export/formats/png_bytes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace gluray::saved {
namespace {

uint8_t byteOf(float v) {
  return static_cast<uint8_t>(std::lround(255 * (v > 0 ? std::min(v, 1.0f) : 0.0f)));
}

/// Red in the lowest byte.
uint32_t texelOf(const scene::TextureImage& image, size_t i) {
  if (!image.texels.empty()) return image.texels[i];
  const glm::vec4& f = image.floats[i];
  return byteOf(f.r) | uint32_t{byteOf(f.g)} << 8 | uint32_t{byteOf(f.b)} << 16 | uint32_t{byteOf(f.a)} << 24;
}

}  // namespace

std::string pngOf(const scene::TextureImage& image, ExportedTexture::Texels texels, bool upright,
                  const PngEncoder& png) {
  using Texels = ExportedTexture::Texels;
  const bool alpha = texels != Texels::opaque && !image.opaque;
  const auto width = static_cast<size_t>(image.width), height = static_cast<size_t>(image.height);
  PngPixels pixels{.width = image.width, .height = image.height, .alpha = alpha};
  std::vector<uint8_t>& bytes = pixels.bytes;
  bytes.reserve(width * height * 4);
  for (size_t row = 0; row < height; ++row)
    for (size_t column = 0; column < width; ++column) {
      uint32_t texel = texelOf(image, (upright ? height - 1 - row : row) * width + column);
      if (texels == Texels::white) texel |= 0xFFFFFFu;
      for (int c = 0; c < (alpha ? 4 : 3); ++c) bytes.push_back(static_cast<uint8_t>(texel >> (8 * c)));
    }
  return png(pixels);
}

}  // namespace gluray::saved
