#include "tests/support/drawn_image.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace gluray::test {
namespace {

int channel(uint32_t color, int k) { return static_cast<int>(color >> (8 * k) & 0xff); }

int farthestChannel(uint32_t a, uint32_t b) {
  int most = 0;
  for (int k = 0; k < 4; ++k) most = std::max(most, std::abs(channel(a, k) - channel(b, k)));
  return most;
}

/// Whether every channel of `color` lies between the extremes of the pixels about (x, y), give or take
/// `slack`.
bool betweenNeighbours(const DrawnImage& p, int x, int y, uint32_t color, int slack) {
  for (int k = 0; k < 4; ++k) {
    int low = 255, high = 0;
    for (int j = std::max(0, y - 1); j <= std::min(p.height - 1, y + 1); ++j)
      for (int i = std::max(0, x - 1); i <= std::min(p.width - 1, x + 1); ++i) {
        const int value = channel(p.colors[static_cast<size_t>(j * p.width + i)], k);
        low = std::min(low, value), high = std::max(high, value);
      }
    if (channel(color, k) < low - slack || channel(color, k) > high + slack) return false;
  }
  return true;
}

}  // namespace

Comparison compare(const DrawnImage& expected, const DrawnImage& got, const scenes::Tolerance& tolerance) {
  Comparison c;
  c.pixels = expected.colors.size();
  if (got.colors.size() != c.pixels || got.depths.size() != expected.depths.size()) {
    c.text = "images of different sizes";
    return c;
  }
  for (size_t i = 0; i < c.pixels; ++i) {
    const int off = farthestChannel(expected.colors[i], got.colors[i]);
    c.colorMax = std::max(c.colorMax, off);
    if (off > tolerance.color) {
      ++c.colorOutside;
      const int x = static_cast<int>(i) % expected.width, y = static_cast<int>(i) / expected.width;
      if (!betweenNeighbours(expected, x, y, got.colors[i], tolerance.color)) ++c.offEdge;
    }
    const bool bothHit = expected.depths[i] < 1 && got.depths[i] < 1;
    const float apart = std::abs(expected.depths[i] - got.depths[i]);
    if (bothHit && apart > tolerance.depth) ++c.depthOutside;
    if (bothHit && off <= tolerance.color) c.depthMax = std::max(c.depthMax, apart);
  }
  const auto total = static_cast<double>(c.pixels), allowed = tolerance.edgeShare * total;
  c.accepted = static_cast<double>(c.colorOutside) <= allowed &&
               static_cast<double>(c.depthOutside) <= allowed &&
               static_cast<double>(c.offEdge) <= allowed / 10;
  char line[256];
  std::snprintf(line, sizeof line,
                "colour: %.3f %% of pixels beyond %d/255 (%zu off edges, most %d); depth: %.3f %% beyond "
                "%.0e (most %.1e)",
                100 * static_cast<double>(c.colorOutside) / total, tolerance.color, c.offEdge, c.colorMax,
                100 * static_cast<double>(c.depthOutside) / total, static_cast<double>(tolerance.depth),
                static_cast<double>(c.depthMax));
  c.text = line;
  return c;
}

bool writePng(const std::string& file, const DrawnImage& drawn) {
  std::vector<uint8_t> rgb;
  for (int y = drawn.height - 1; y >= 0; --y)
    for (int x = 0; x < drawn.width; ++x)
      for (int k = 0; k < 3; ++k)
        rgb.push_back(
            static_cast<uint8_t>(channel(drawn.colors[static_cast<size_t>(y * drawn.width + x)], k)));
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(drawn.width), image.height = static_cast<png_uint_32>(drawn.height);
  image.format = PNG_FORMAT_RGB;
  return png_image_write_to_file(&image, file.c_str(), 0, rgb.data(), 0, nullptr) != 0;
}

void writeFailure(const std::string& folder, const std::string& name, const DrawnImage& expected,
                  const DrawnImage& got) {
  std::filesystem::create_directories(folder);
  DrawnImage difference = expected;
  for (size_t i = 0; i < std::min(expected.colors.size(), got.colors.size()); ++i) {
    uint32_t color = 0xff000000;
    for (int k = 0; k < 3; ++k) {
      const int off = std::abs(channel(expected.colors[i], k) - channel(got.colors[i], k));
      color |= static_cast<uint32_t>(std::min(255, off * 8)) << (8 * k);
    }
    difference.colors[i] = color;
  }
  writePng(folder + "/" + name + "-expected.png", expected);
  writePng(folder + "/" + name + "-got.png", got);
  writePng(folder + "/" + name + "-diff.png", difference);
}

}  // namespace gluray::test
