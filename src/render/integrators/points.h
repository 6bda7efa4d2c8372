// Computes the points of hits for integrators. Any thread.
#pragma once
#include "render/integrators/integrator.h"
#include "render/integrators/metric.h"
#include "render/integrators/surface_points.h"

namespace gluray::render {

/// Computes the group's points. Lanes outside the group repeat one of its lanes.
void askedPointsOf(const Metric&, const FrameData&, const ColoredHits&, AskedPoints&);

}  // namespace gluray::render
