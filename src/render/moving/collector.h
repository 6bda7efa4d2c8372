// Writes hits to the visibility buffer with their reprojected history, and traces their visibility.
#pragma once
#include "render/integrators/light_visibility.h"
#include "render/integrators/metric.h"
#include "render/moving/moving_frame.h"
#include "render/moving/waiting_points.h"

namespace gluray::render {

/// Integrator of the first pass over a moving frame; does not change colours.
class Collector final : public Integrator {
 public:
  /// All must outlive it.
  Collector(const FrameData& frame, const MovingFrame& moving, const VisibilityIntegrator& integrator,
            const Metric& metric)
      : frame(frame), moving(moving), integrator(integrator), metric(metric) {}
  /// Adds points that need rays to ColoredHits::waiting, and traces each full packet of them.
  void light(const ColoredHits&, ColorRows&) const noexcept override;
  /// Traces the remaining points.
  void finish(WaitingPoints&) const noexcept;

  const FrameData& frame;
  const MovingFrame& moving;
  const VisibilityIntegrator& integrator;
  const Metric& metric;
};

}  // namespace gluray::render
