// A rectangle of a window, compared with what should be seen there. Used by one thread at a time.
#pragma once
#include "base/idle_window.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gluray::frame {

constexpr uint32_t kColors = 0xffffff;  // of an RGBA8 colour, without alpha

/// The colour at a place of the window; null: outside.
inline const uint32_t* colorAt(const WindowPixels& window, glm::ivec2 place) {
  if (place.x < 0 || place.y < 0 || place.x >= window.width || place.y >= window.height) return nullptr;
  return &window.colors[static_cast<size_t>(place.y) * static_cast<size_t>(window.width) +
                        static_cast<size_t>(place.x)];
}

/// A rectangle of the window in which something should be seen, and the pixels that are equal to it.
struct Compared {
  const WindowPixels& window;
  glm::ivec2 corner, size;
  std::vector<bool> equal;

  glm::ivec2 placeOf(size_t i) const { return {static_cast<int>(i) % size.x, static_cast<int>(i) / size.x}; }
  const uint32_t* shownAt(glm::ivec2 at) const { return colorAt(window, corner + at); }
  /// Calls work(place, index) for the pixels of the rectangle that are at most `reach` away, until it
  /// returns false. Returns whether it never did.
  template <class Work>
  bool around(glm::ivec2 at, int reach, const Work& work) const {
    const glm::ivec2 low = glm::max(at - reach, glm::ivec2(0)), high = glm::min(at + reach, size - 1);
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x)
        if (!work(glm::ivec2(x, y), static_cast<size_t>(y * size.x + x))) return false;
    return true;
  }
};

/// Whether a pixel that is equal shows what is compared: no pixel close by that does not show it has its
/// colour. Noise may equal a flat overlay here and there, but not all around.
bool isVisible(const Compared& compared, glm::ivec2 at);

}  // namespace gluray::frame
