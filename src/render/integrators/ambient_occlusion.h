// Ambient occlusion: surfaces are darkened by what hides the sky above them.
#pragma once
#include "render/integrators/factors.h"
#include "render/integrators/metric.h"
#include "render/integrators/occluders.h"

namespace gluray::render {

/// The open part of the hemisphere above a point,
///   A = 1 - strength/pi * integral of (1 - V(w)) cos(n, w) dw,  V = 0 where something lies within `radius`.
/// Directions are drawn in proportion to the cosine, so that the estimate is 1 - strength * blocked /
/// samples. Source: Zhukov, Iones, Kronin, "An Ambient Light Illumination Model", 1998. Colours of the local
/// look are multiplied by it.
class AmbientOcclusion final : public FactorIntegrator {
 public:
  /// `frame` must outlive it. Throws std::runtime_error where the modelview matrix cannot be inverted.
  explicit AmbientOcclusion(const FrameData& frame);
  UsedFactors used() const noexcept override { return {true, 0, false}; }
  void estimate(const ColoredHits&, Factors&) const noexcept override;
  void apply(const ColoredHits&, const Factors&, ColorRows&) const noexcept override;

  const FrameData& frame;
  Metric metric;
  Occluders occluders;
  int samples;     // rays a point, >= 1; noise falls as 1/sqrt(samples)
  float radius;    // eye space
  float strength;  // 0: no effect, 1: full
};

}  // namespace gluray::render
