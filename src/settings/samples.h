// Rays that a pixel takes where the framebuffer has one sample a pixel. Any thread.
#pragma once
#include "settings/settings.h"

#include <algorithm>

namespace gluray {

constexpr int kMinLensSamples = 16;  // rays through an open lens; with fewer, blurred edges fall apart

/// Whether settings ask for depth of field.
inline bool hasOpenLens(const Settings& settings) {
  return settings.camera.aperture > 0 || settings.camera.fNumber > 0;
}

/// The setting spp, and no fewer rays than an open lens needs.
inline int samplesPerPixel(const Settings& settings) {
  return hasOpenLens(settings) ? std::max(settings.spp, kMinLensSamples) : settings.spp;
}

}  // namespace gluray
