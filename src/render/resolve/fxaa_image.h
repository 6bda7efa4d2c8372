// Input of the FXAA filter. Any thread.
#pragma once
#include <cstdint>

namespace gluray::render {

/// RGBA8 pixels, red in the lowest byte, and their luminosity, bottom row first.
struct FxaaImage {
  const uint32_t* pixels;
  const float* luminosity;
  int width, height;
};

}  // namespace gluray::render
