// Fast approximate anti-aliasing of a finished picture on the CPU. Source: VTK 9's vtkFXAAFilter with its
// endpoint search for high quality, which follows T. Lottes, "FXAA", NVIDIA 2009.
#pragma once
#include "scene/fxaa.h"

#include <cstdint>
#include <vector>

namespace gluray::render {

/// Memory that is kept from picture to picture.
struct FxaaMemory {
  std::vector<float> luminosity;
};

/// RGBA8 pixels with red in the lowest byte and their luminosity, lowest row first.
struct FxaaPicture {
  const uint32_t* pixels;
  const float* luminosity;
  int width, height;
};

/// Anti-aliases `in` into `out`: RGBA8 with red in the lowest byte, width*height pixels, lowest row first.
/// Pixels beyond the border repeat those at it. Runs on the threads of the calling arena.
void fxaa(const scene::Fxaa& settings, const uint32_t* in, int width, int height, uint32_t* out,
          FxaaMemory& memory);

}  // namespace gluray::render
