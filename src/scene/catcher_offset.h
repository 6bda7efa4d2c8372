// The polygon offset that surfaces get which catch light over what the real OpenGL has drawn: it brings them
// before the depths in the framebuffer, which differ by rounding (Snapshot::catches).
#pragma once
#include "scene/snapshot.h"

namespace gluray::scene {

/// Added to the program's own factor: a twentieth of a pixel along the surface; up to the samples of a pixel,
/// which are up to half a pixel away from its centre along each axis.
inline constexpr float kCatcherSlope = -0.05f, kCatcherSlopeToSamples = -1.05f;

/// Added to its own units: depth steps.
inline constexpr float kCatcherUnits = -16;

/// Whether the program's own offset decides by the surfaces' slopes which of them is seen.
inline bool ordersBySlope(const Snapshot& s) {
  const float factor = s.polygonOffset.factor;
  return s.catches ? factor != kCatcherSlope && factor != kCatcherSlopeToSamples : factor != 0;
}

}  // namespace gluray::scene
