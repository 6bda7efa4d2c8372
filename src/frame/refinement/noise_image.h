// Images of noise (look = noise). Any thread.
#pragma once
#include "base/image.h"

#include <cstdint>
#include <vector>

namespace gluray::frame {

/// Colours each pixel with a hit by its standard error: black for 0, red for `allowed`, yellow for twice and
/// white for four times `allowed`. `noise`: one value per pixel, render::kNoiseOne being 1; empty: unknown,
/// shown as white. Alpha stays.
void paintNoise(const std::vector<uint16_t>& noise, float allowed, Image& image);

/// Paints an image without noise: black.
void paintNoNoise(Image& image);

}  // namespace gluray::frame
