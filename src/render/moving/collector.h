// Traces the factors of hits and puts them onto the film, together with what earlier frames know of them.
#pragma once
#include "render/integrators/factors.h"
#include "render/integrators/metric.h"
#include "render/moving/moving_frame.h"

namespace gluray::render {

/// An integrator of the first pass over a moving frame: it changes no colours.
class Collector final : public Integrator {
 public:
  /// All must outlive it.
  Collector(const FrameData& frame, const MovingFrame& moving, const FactorIntegrator& factors,
            const Metric& metric)
      : frame(frame), moving(moving), factors(factors), metric(metric) {}
  void light(const ColoredHits&, ColorRows&) const noexcept override;

  const FrameData& frame;
  const MovingFrame& moving;
  const FactorIntegrator& factors;
  const Metric& metric;
};

}  // namespace gluray::render
