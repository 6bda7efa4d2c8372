// Rays that a pixel takes where the framebuffer has one sample a pixel. Any thread.
#pragma once
#include "settings/settings.h"

#include <algorithm>

namespace gluray {

constexpr int kLeastLensSamples = 16;  // rays through an open lens; with fewer, blurred edges fall apart

/// The setting spp, and no fewer rays than an open lens needs.
inline int samplesPerPixel(const Settings& settings) {
  return settings.camera.aperture > 0 ? std::max(settings.spp, kLeastLensSamples) : settings.spp;
}

}  // namespace gluray
