// Images like the tracer's, for tests of code that uses them.
#pragma once
#include "base/image.h"

#include <cstdint>

namespace gluray::present::test {

inline constexpr uint32_t kRed = 0xff0000ff, kGreen = 0xff00ff00, kBlue = 0xffff0000;

/// A traced rectangle at one depth.
inline Image solid(int x, int y, int width, int height, uint32_t color, float depth) {
  Image image;
  image.x = x, image.y = y;
  image.resize(width, height, 1);
  image.color.assign(image.color.size(), color);
  image.depth.assign(image.depth.size(), depth);
  return image;
}

}  // namespace gluray::present::test
