#include "gl/framebuffers/composed_pixels.h"

#include <cstddef>

namespace gluray::gl {
namespace {

uint32_t channel(uint32_t color, int shift) { return color >> shift & 255; }

/// Whether `after` is `over`, whose colours are premultiplied, blended over `under`.
bool isBlended(uint32_t over, uint32_t under, uint32_t after) {
  const uint32_t alpha = over >> 24;
  if (alpha == 255) return after == over;
  for (int shift = 0; shift < 32; shift += 8) {
    const uint32_t sum = channel(over, shift) * 255 + channel(under, shift) * (255 - alpha);
    const uint32_t expected = sum < 255 * 255 ? sum : 255 * 255, found = channel(after, shift) * 255;
    if (found > expected + 255 || expected > found + 255) return false;
  }
  return true;
}

}  // namespace

bool isComposed(const std::vector<uint32_t>& before, const std::vector<uint32_t>& shown, uint32_t empty,
                const std::vector<uint32_t>& after) {
  const size_t pixels = shown.size();
  if (before.size() != pixels || after.size() != pixels) return false;
  size_t changed = 0;
  for (size_t i = 0; i < pixels; ++i) {
    if (isBlended(shown[i], before[i], after[i])) {
      changed += shown[i] != empty && after[i] != before[i];
      continue;
    }
    const bool isCovered = shown[i] != empty && shown[i] >> 24 == 255;
    if (isCovered || after[i] != before[i]) return false;
  }
  return changed > 0;
}

}  // namespace gluray::gl
