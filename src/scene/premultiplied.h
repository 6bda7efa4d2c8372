// Colours whose red, green and blue are multiplied by alpha: RGBA8, or floats. Any thread.
#pragma once
#include <glm/glm.hpp>

#include <algorithm>
#include <cstdint>

namespace gluray::scene {

/// Composites premultiplied `over` onto `under`.
inline uint32_t blended(uint32_t over, uint32_t under) {
  constexpr uint32_t kFull = 255;
  const uint32_t through = kFull - (over >> 24);
  uint32_t result = 0;
  for (int shift = 0; shift < 32; shift += 8) {
    const uint32_t a = (over >> shift) & kFull, b = (under >> shift) & kFull;
    result |= std::min(kFull, a + (b * through + kFull / 2) / kFull) << shift;
  }
  return result;
}

/// The same of floats, which are not limited.
inline glm::vec4 blended(const glm::vec4& over, const glm::vec4& under) {
  return over + under * (1 - over.a);
}

/// RGBA8 as floats, 0 .. 1.
inline glm::vec4 wideOf(uint32_t color) {
  return glm::vec4(color & 255u, color >> 8 & 255u, color >> 16 & 255u, color >> 24) / 255.0f;
}

/// The same colour with full opacity. `color` has some.
inline uint32_t opaque(uint32_t color) {
  constexpr uint32_t kFull = 255;
  const uint32_t alpha = color >> 24;
  uint32_t result = kFull << 24;
  for (int shift = 0; shift < 24; shift += 8)
    result |= std::min(kFull, ((color >> shift & kFull) * kFull + alpha / 2) / alpha) << shift;
  return result;
}

}  // namespace gluray::scene
