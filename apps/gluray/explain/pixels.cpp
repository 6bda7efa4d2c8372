#include "explain/pixels.h"

#include <png.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace gluray::launcher {
namespace {

Origin originAt(const Pixels& origin, size_t pixel) { return static_cast<Origin>(origin.bytes[pixel]); }

int largestDifference(const Pixels& a, const Pixels& b, size_t pixel) {
  int largest = 0;
  for (int c = 0; c < a.channels; ++c) largest = std::max(largest, std::abs(a.at(pixel)[c] - b.at(pixel)[c]));
  return largest;
}

/// For each pixel, whether a pixel that was traced (or drawn over later) lies within `margin` of it.
std::vector<bool> nearTraced(const Pixels& origin, int margin) {
  std::vector<bool> near(origin.count(), false);
  for (int y = 0; y < origin.height; ++y)
    for (int x = 0; x < origin.width; ++x) {
      const size_t pixel =
          static_cast<size_t>(y) * static_cast<size_t>(origin.width) + static_cast<size_t>(x);
      if (originAt(origin, pixel) == Origin::rasterised) continue;
      for (int v = std::max(0, y - margin); v <= std::min(origin.height - 1, y + margin); ++v)
        for (int u = std::max(0, x - margin); u <= std::min(origin.width - 1, x + margin); ++u)
          near[static_cast<size_t>(v) * static_cast<size_t>(origin.width) + static_cast<size_t>(u)] = true;
    }
  return near;
}

}  // namespace

std::optional<Pixels> readNetpbm(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string magic;
  int largest = 0;
  Pixels pixels;
  if (!(file >> magic >> pixels.width >> pixels.height >> largest)) return std::nullopt;
  constexpr int kMax = 1 << 15;
  if ((magic != "P5" && magic != "P6") || largest != 255 || pixels.width <= 0 || pixels.height <= 0 ||
      pixels.width > kMax || pixels.height > kMax)
    return std::nullopt;
  file.get();  // the one character after the header
  pixels.channels = magic == "P6" ? 3 : 1;
  pixels.bytes.resize(pixels.count() * static_cast<size_t>(pixels.channels));
  file.read(reinterpret_cast<char*>(pixels.bytes.data()), static_cast<std::streamsize>(pixels.bytes.size()));
  if (file.gcount() != static_cast<std::streamsize>(pixels.bytes.size())) return std::nullopt;
  return pixels;
}

std::string pngOf(const Pixels& pixels) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(pixels.width);
  image.height = static_cast<png_uint_32>(pixels.height);
  image.format = pixels.channels == 3 ? PNG_FORMAT_RGB : PNG_FORMAT_GRAY;
  png_alloc_size_t size = 0;
  if (!png_image_write_get_memory_size(image, size, 0, pixels.bytes.data(), 0, nullptr))
    throw std::runtime_error(std::string("no PNG: ") + image.message);
  std::string bytes(size, '\0');
  if (!png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.bytes.data(), 0, nullptr))
    throw std::runtime_error(std::string("no PNG: ") + image.message);
  bytes.resize(size);
  return bytes;
}

Comparison compare(const Pixels& with, const Pixels& without, const Pixels& origin) {
  Comparison result;
  const auto sameShape = [&](const Pixels& p) { return p.width == with.width && p.height == with.height; };
  result.sameSize = sameShape(without) && sameShape(origin) && with.channels == without.channels;
  if (!result.sameSize) return result;
  result.pixels = with.count();
  const std::vector<bool> near = nearTraced(origin, Comparison::kMargin);
  for (size_t i = 0; i < with.count(); ++i) {
    result.traced += originAt(origin, i) == Origin::traced;
    result.drawnOver += originAt(origin, i) == Origin::drawnOver;
    const int here = largestDifference(with, without, i);
    result.largest = std::max(result.largest, here);
    result.differingAtAll += here > 0;
    result.differing += here > Comparison::kTolerance;
    result.outside += !near[i];
    result.outsideDiffering += !near[i] && here > Comparison::kTolerance;
  }
  return result;
}

Pixels difference(const Pixels& a, const Pixels& b, int times) {
  Pixels result = a;
  for (size_t i = 0; i < result.bytes.size(); ++i)
    result.bytes[i] = static_cast<uint8_t>(std::min(255, times * std::abs(a.bytes[i] - b.bytes[i])));
  return result;
}

Pixels tinted(const Pixels& image, const Pixels& origin) {
  Pixels result = image;
  for (size_t i = 0; i < image.count(); ++i) {
    const uint8_t* rgb = image.at(i);
    const int grey = (rgb[0] * 77 + rgb[1] * 151 + rgb[2] * 28) >> 8;
    const bool traced = originAt(origin, i) == Origin::traced,
               over = originAt(origin, i) == Origin::drawnOver;
    uint8_t* out = result.bytes.data() + 3 * i;
    out[0] = static_cast<uint8_t>(over ? 128 + grey / 2 : grey / 2);
    out[1] = static_cast<uint8_t>(traced ? 112 + grey / 2 : over ? 80 + grey / 2 : grey / 2);
    out[2] = static_cast<uint8_t>(grey / 2);
  }
  return result;
}

}  // namespace gluray::launcher
