#include "gl/pending/cleared_pixels.h"

#include <algorithm>
#include <cmath>

namespace gluray::gl {
namespace {

/// Whether two bytes stand for one value: OpenGLs differ in how they round.
bool isNear(uint32_t a, uint32_t b) { return a > b ? a - b <= 1 : b - a <= 1; }

bool isNear(uint32_t a, uint32_t b, int bits) {
  for (int shift = 0; shift < bits; shift += 8)
    if (!isNear(a >> shift & 255, b >> shift & 255)) return false;
  return true;
}

}  // namespace

std::optional<scene::Backdrop> backdropWhere(const std::vector<uint32_t>& colors,
                                             const glm::vec4& clearColor) {
  uint32_t cleared = 0;
  for (int c = 0; c < 4; ++c)
    cleared |= static_cast<uint32_t>(std::lrint(std::clamp(clearColor[c], 0.0f, 1.0f) * 255)) << (8 * c);
  const bool alpha =
      std::any_of(colors.begin(), colors.end(), [](uint32_t color) { return color >> 24 != 255; });
  size_t count = 0;
  scene::Backdrop backdrop;
  backdrop.isClear.reserve(colors.size());
  for (const uint32_t color : colors) {
    const bool clear = isNear(color, cleared, alpha ? 32 : 24);
    backdrop.isClear.push_back(clear);
    count += clear;
  }
  if (2 * count < colors.size()) return std::nullopt;
  return backdrop;
}

}  // namespace gluray::gl
