// Edges of surfaces in a window whose image was written with one sample per pixel, and is refined with
// several: pixels that the refined image covers only partly. Used by one thread at a time.
#pragma once
#include "frame/idle/compared_pixels.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace gluray::frame {

/// What surrounds the pixels of an image in its window.
struct EdgeSurroundings {
  const Compared& compared;          // with the image as it was written
  const std::vector<uint8_t>& hits;  // 0: the pixel shows no surface of the image
  /// Whether an image of the frame covers this place of the rectangle.
  std::function<bool(glm::ivec2)> isCovered;
};

/// The colour behind the surfaces at a pixel near their edge: that of the pixels around it without a surface,
/// if it changes little there. None: no edge is near, something else may be drawn over the edge, or the
/// colours differ.
std::optional<uint32_t> colorBehind(const EdgeSurroundings& around, glm::ivec2 at);

/// What the window shows of a pixel of a refined image that averages samples: premultiplied `color`, over
/// `behind` if that is known. Otherwise surfaces cover the whole pixel; none if there is no surface.
std::optional<uint32_t> shownColor(uint32_t color, std::optional<uint32_t> behind);

}  // namespace gluray::frame
