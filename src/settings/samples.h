// Samples per pixel in framebuffers without multisampling. Any thread.
#pragma once
#include "settings/settings.h"

#include <algorithm>

namespace gluray {

constexpr int kMinLensSamples = 16;  // rays through an open lens; fewer make blurred edges visibly grainy

/// Whether settings request depth of field.
inline bool hasOpenLens(const Settings& settings) {
  return settings.camera.aperture > 0 || settings.camera.fNumber > 0;
}

/// Pixels get one sample each, through a closed lens.
inline void takeOneSample(Settings& settings) {
  settings.spp = 1, settings.pixelFilter = PixelFilter::box;
  settings.camera.aperture = settings.camera.fNumber = 0;
}

/// The setting spp, but at least the number of rays that an open lens needs.
inline int samplesPerPixel(const Settings& settings) {
  return hasOpenLens(settings) ? std::max(settings.spp, kMinLensSamples) : settings.spp;
}

/// Whether pixels of a framebuffer with so many samples average more: through an open lens all samples of a
/// pixel get the same average.
inline bool averagesSamples(const Settings& settings, int framebufferSamples) {
  return hasOpenLens(settings) || (framebufferSamples <= 1 && settings.spp > 1);
}

}  // namespace gluray
