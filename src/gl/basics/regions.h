// Rectangles of pixels that OpenGL's state gives. Any thread.
#pragma once
#include "scene/region.h"

#include <algorithm>

namespace gluray::gl {

/// What both have in common; without width or height if that is nothing.
inline scene::Region common(const scene::Region& a, const scene::Region& b) {
  const int x = std::max(a.x, b.x), y = std::max(a.y, b.y);
  return {x, y, std::max(0, std::min(a.x + a.width, b.x + b.width) - x),
          std::max(0, std::min(a.y + a.height, b.y + b.height) - y)};
}

}  // namespace gluray::gl
