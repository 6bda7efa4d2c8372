// Pictures of noise (look = noise). Any thread.
#pragma once
#include "base/image.h"

#include <cstdint>
#include <vector>

namespace gluray::frame {

/// Gives each pixel that a ray hit a colour for its standard error: black for none, red for what `allowed`
/// is, yellow for twice and white for four times as much. `noise`: of each pixel, render::kNoiseOne being 1;
/// empty: it is not known, which is white. Alpha stays.
void paintNoise(const std::vector<uint16_t>& noise, float allowed, Image& image);

/// The same for pictures without noise: black.
void paintNoNoise(Image& image);

}  // namespace gluray::frame
