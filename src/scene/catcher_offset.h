// Polygon offset of surfaces that apply light to pixels of the real OpenGL. It moves them in front of the
// depths in the framebuffer, which differ by rounding (Snapshot::catches).
#pragma once
#include "scene/snapshot.h"

namespace gluray::scene {

/// Added to the program's own factor: a twentieth of a pixel along the surface; and for multisampling, where
/// samples are up to half a pixel away from the pixel centre along each axis.
inline constexpr float kCatcherSlope = -0.05f, kCatcherSlopeToSamples = -1.05f;

/// Added to its own units: depth steps.
inline constexpr float kCatcherUnits = -16;

/// Whether the visibility of surfaces depends on their slopes through the program's own offset.
inline bool ordersBySlope(const Snapshot& s) {
  const float factor = s.polygonOffset.factor;
  return s.catches ? factor != kCatcherSlope && factor != kCatcherSlopeToSamples : factor != 0;
}

}  // namespace gluray::scene
