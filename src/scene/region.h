// A rectangle of pixels.
#pragma once
#include <algorithm>

namespace gluray::scene {

/// The rectangle of pixels to trace: viewport, scissor and framebuffer intersected. Never empty in a
/// snapshot.
struct Region {
  int x = 0, y = 0, width = 0, height = 0;
  bool operator==(const Region&) const = default;
};

/// The smallest region that contains both.
inline Region united(const Region& a, const Region& b) {
  if (a.width <= 0) return b;
  if (b.width <= 0) return a;
  const int x = std::min(a.x, b.x), y = std::min(a.y, b.y);
  return {x, y, std::max(a.x + a.width, b.x + b.width) - x, std::max(a.y + a.height, b.y + b.height) - y};
}

inline bool haveCommonPixels(const Region& a, const Region& b) {
  return std::max(a.x, b.x) < std::min(a.x + a.width, b.x + b.width) &&
         std::max(a.y, b.y) < std::min(a.y + a.height, b.y + b.height);
}

}  // namespace gluray::scene
