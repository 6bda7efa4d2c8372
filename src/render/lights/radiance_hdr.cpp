#include "render/lights/sky_files.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace gluray::render {
namespace {

constexpr size_t kMaxPixels = size_t{1} << 25;

/// Takes bytes in order; throws at the end.
struct Bytes {
  const std::string& all;
  size_t at = 0;
  uint8_t next() {
    if (at >= all.size()) throw std::runtime_error("the image ends early");
    return static_cast<uint8_t>(all[at++]);
  }
  std::string line() {
    const size_t end = all.find('\n', at);
    if (end == std::string::npos) throw std::runtime_error("the image has no header");
    std::string text = all.substr(at, end - at);
    at = end + 1;
    return text;
  }
};

glm::vec3 colorOf(const uint8_t* p) {
  if (p[3] == 0) return glm::vec3(0);
  const float scale = std::ldexp(1.0f, p[3] - (128 + 8));
  return glm::vec3(p[0], p[1], p[2]) * scale;
}

/// One row, each channel in runs (newer files), or pixel by pixel with repeats (older ones).
void readRow(Bytes& bytes, size_t width, std::vector<uint8_t>& row) {
  uint8_t first[4];
  for (uint8_t& b : first) b = bytes.next();
  const bool runs = first[0] == 2 && first[1] == 2 && first[2] < 128 && width >= 8 && width < 32768;
  if (runs) {
    if (static_cast<size_t>(first[2] << 8 | first[3]) != width)
      throw std::runtime_error("a row has another width");
    for (size_t c = 0; c < 4; ++c)
      for (size_t x = 0; x < width;) {
        size_t count = bytes.next();
        const bool same = count > 128;
        if (same) count -= 128;
        if (count == 0 || x + count > width) throw std::runtime_error("a run does not fit its row");
        uint8_t value = same ? bytes.next() : uint8_t{0};
        for (; count > 0; --count, ++x) row[4 * x + c] = same ? value : (value = bytes.next());
      }
    return;
  }
  int shift = 0;
  for (size_t x = 0; x < width;) {
    uint8_t p[4];
    for (int c = 0; c < 4; ++c) p[c] = x == 0 && shift == 0 ? first[c] : bytes.next();
    if (p[0] == 1 && p[1] == 1 && p[2] == 1) {
      size_t count = size_t{p[3]} << shift;
      if (x == 0 || shift > 24 || x + count > width)
        throw std::runtime_error("a repeat does not fit its row");
      for (; count > 0; --count, ++x) std::copy_n(&row[4 * (x - 1)], 4, &row[4 * x]);
      shift += 8;
    } else {
      std::copy_n(p, 4, &row[4 * x]);
      ++x, shift = 0;
    }
  }
}

}  // namespace

SkyPixels readRadiance(const std::string& content) {
  Bytes bytes{content};
  const std::string magic = bytes.line();
  if (!magic.starts_with("#?")) throw std::runtime_error("it is no Radiance image");
  for (std::string line = bytes.line(); !line.empty() && line != "\r"; line = bytes.line())
    if (line.starts_with("FORMAT=") && line.find("32-bit_rle_rgbe") == std::string::npos)
      throw std::runtime_error("only Radiance images of the format 32-bit_rle_rgbe can be read");
  int width = 0, height = 0;
  if (std::sscanf(bytes.line().c_str(), "-Y %d +X %d", &height, &width) != 2 || width <= 0 || height <= 0)
    throw std::runtime_error("rows must go down and columns right (-Y height +X width)");
  const auto w = static_cast<size_t>(width), h = static_cast<size_t>(height);
  if (w * h > kMaxPixels) throw std::runtime_error("the image has more than 33 million pixels");
  SkyPixels image{width, height, std::vector<glm::vec3>(w * h)};
  std::vector<uint8_t> row(4 * w);
  for (size_t y = 0; y < h; ++y) {
    readRow(bytes, w, row);
    for (size_t x = 0; x < w; ++x) image.pixels[y * w + x] = colorOf(&row[4 * x]);
  }
  return image;
}

}  // namespace gluray::render
