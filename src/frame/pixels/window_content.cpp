#include "frame/pixels/window_content.h"

#include "scene/premultiplied.h"

#include <algorithm>
#include <cstddef>

namespace gluray::frame {

WindowContent plainWindow(glm::ivec2 size, uint32_t color, float depth) {
  const auto pixels = static_cast<size_t>(size.x) * static_cast<size_t>(size.y);
  return {size.x, size.y, std::vector<uint32_t>(pixels, color), std::vector<float>(pixels, depth)};
}

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
      color = averages ? scene::blended(image.color[source], color) : image.color[source];
    }
  }
  return true;
}

}  // namespace gluray::frame
