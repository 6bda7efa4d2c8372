// Where hits are, for integrators. Any thread.
#pragma once
#include "render/integrators/integrator.h"
#include "render/integrators/metric.h"
#include "render/integrators/surface_points.h"

namespace gluray::render {

/// The group's points. Rows of other lanes are those of one of its lanes.
void askedPointsOf(const Metric&, const FrameData&, const ColoredHits&, AskedPoints&);

}  // namespace gluray::render
