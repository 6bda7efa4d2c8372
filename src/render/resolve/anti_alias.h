// Fast approximate anti-aliasing (FXAA) of a finished image on the CPU. Source: VTK 9's vtkFXAAFilter with
// its high-quality endpoint search, after T. Lottes, "FXAA", NVIDIA 2009. Called by frame::Renderer.
#pragma once
#include "scene/fxaa.h"

#include <cstdint>
#include <vector>

namespace gluray::render {

/// Scratch memory, reused between images.
struct FxaaMemory {
  std::vector<float> luminosity;
};

/// Anti-aliases `in` into `out`: RGBA8, red in the lowest byte, width*height pixels, bottom row first. Pixels
/// beyond the border repeat the border. Runs on the threads of the calling arena.
void fxaa(const scene::Fxaa& settings, const uint32_t* in, int width, int height, uint32_t* out,
          FxaaMemory& memory);

}  // namespace gluray::render
