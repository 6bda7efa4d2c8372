#include "frame/pixels/window_content.h"

#include <algorithm>
#include <cstddef>

namespace gluray::frame {

WindowContent plainWindow(glm::ivec2 size, uint32_t color, float depth) {
  const auto pixels = static_cast<size_t>(size.x) * static_cast<size_t>(size.y);
  return {size.x, size.y, std::vector<uint32_t>(pixels, color), std::vector<float>(pixels, depth)};
}

namespace {

/// Composites premultiplied `over` onto `under`.
uint32_t blended(uint32_t over, uint32_t under) {
  constexpr uint32_t kFull = 255;
  const uint32_t through = kFull - (over >> 24);
  uint32_t result = 0;
  for (int shift = 0; shift < 32; shift += 8) {
    const uint32_t a = (over >> shift) & kFull, b = (under >> shift) & kFull;
    result |= std::min(kFull, a + (b * through + kFull / 2) / kFull) << shift;
  }
  return result;
}

}  // namespace

bool merge(const Image& image, DepthTest test, WindowContent& content) noexcept {
  if (!image.has(Plane::color) || image.samples != 1) return false;
  const bool averages = image.isAverages();
  const int left = std::max(0, -image.x), right = std::min(image.width, content.width - image.x);
  for (int y = std::max(0, -image.y); y < std::min(image.height, content.height - image.y); ++y) {
    const size_t from = static_cast<size_t>(y) * static_cast<size_t>(image.width);
    const size_t to = static_cast<size_t>(y + image.y) * static_cast<size_t>(content.width) +
                      static_cast<size_t>(image.x + left);
    for (int x = left; x < right; ++x) {
      const size_t source = from + static_cast<size_t>(x), target = to + static_cast<size_t>(x - left);
      const float depth = image.depth[source], there = content.depths[target];
      if (depth == Image::kMiss || !(test == DepthTest::less ? depth < there : depth <= there)) continue;
      uint32_t& color = content.colors[target];
      color = averages ? blended(image.color[source], color) : image.color[source];
    }
  }
  return true;
}

}  // namespace gluray::frame
