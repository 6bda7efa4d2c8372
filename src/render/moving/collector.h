// Puts hits onto the film with what earlier frames know of them, and traces their factors of light.
#pragma once
#include "render/integrators/factors.h"
#include "render/integrators/metric.h"
#include "render/moving/moving_frame.h"
#include "render/moving/waiting_points.h"

namespace gluray::render {

/// An integrator of the first pass over a moving frame: it changes no colours.
class Collector final : public Integrator {
 public:
  /// All must outlive it.
  Collector(const FrameData& frame, const MovingFrame& moving, const FactorIntegrator& factors,
            const Metric& metric)
      : frame(frame), moving(moving), factors(factors), metric(metric) {}
  /// Points that trace rays join ColoredHits::waiting, which traces those that fill a packet.
  void light(const ColoredHits&, ColorRows&) const noexcept override;
  /// Traces what still waits.
  void finish(WaitingPoints&) const noexcept;

  const FrameData& frame;
  const MovingFrame& moving;
  const FactorIntegrator& factors;
  const Metric& metric;
};

}  // namespace gluray::render
