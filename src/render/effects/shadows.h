// Shadows: the visibility of each light. Made once a frame, called on all tracing threads.
#pragma once
#include "render/effects/shadow_lights.h"
#include "render/integrators/light_visibility.h"
#include "render/integrators/metric.h"
#include "render/integrators/occluders.h"

namespace gluray::render {

/// The visibility of a light from a point,
///   V = integral of T(w) f(w) dw / integral of f(w) dw  over the light's directions,
/// with the transmittance T of surfaces in the way, and f the light's radiance times cos(n, w). The shadowed
/// light is V times the noise-free light of the surface's equation (E. Heitz, S. Hill, M. McGuire, "Combining
/// Analytic Direct Illumination and Stochastic Shadows", 2018).
struct Shadows {
  Shadows(const FrameData&, const Metric&, const Occluders&, const ShadowLights&);
  /// Whether the light has a size, so that its shadows are soft.
  bool isSampled(int row) const;
  /// Rays per point for a light; one for hard shadows.
  int raysOf(int row) const { return isSampled(row) ? samples : 1; }
  /// Fills the rows of Visibility::lights.
  void estimate(const AskedPoints&, Visibility&) const noexcept;

  const FrameData& frame;
  const Metric& metric;
  const Occluders& occluders;
  const ShadowLights& lights;
  int samples;     // rays a light and point, >= 1
  float size;      // degrees, of lights without a size of their own
  float strength;  // 0: no shadows, 1: full
};

}  // namespace gluray::render
