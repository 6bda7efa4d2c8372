// Shadows: what of each light arrives past other surfaces. Made once a frame, asked on all tracing threads.
#pragma once
#include "render/effects/shadow_lights.h"
#include "render/integrators/factors.h"
#include "render/integrators/metric.h"
#include "render/integrators/occluders.h"

namespace gluray::render {

/// The visibility of a light from a point,
///   V = integral of T(w) f(w) dw / integral of f(w) dw  over the light's directions,
/// with the share T of light that passes surfaces, and f the light's radiance times cos(n, w). Multiplied by
/// the light as the surface's equation has it, without noise, it gives the shadowed light (E. Heitz, S. Hill,
/// M. McGuire, "Combining Analytic Direct Illumination and Stochastic Shadows", 2018).
struct Shadows {
  Shadows(const FrameData&, const Metric&, const Occluders&, const ShadowLights&);
  /// Rays that a light needs from each point; one if its shadows are hard.
  int raysOf(int row) const;
  /// Fills the rows of Factors::visibility.
  void estimate(const AskedPoints&, Factors&) const noexcept;

  const FrameData& frame;
  const Metric& metric;
  const Occluders& occluders;
  const ShadowLights& lights;
  int samples;     // rays a light and point, >= 1
  float size;      // degrees, of lights without a size of their own
  float strength;  // 0: no shadows, 1: full
};

}  // namespace gluray::render
