// Points of impostors in eye space. Part of the integrators' point maker (points.inl.h); any thread.
#pragma once
#include "render/integrators/integrator.h"
#include "render/integrators/metric.h"

namespace gluray::render {

/// Eye-space points and unit normals of the group's lanes, on the solids that secondary rays meet
/// (accel/impostors/solid.h): what programs draw of beads, tubes and splats lies within or before these.
/// Lanes outside the group get those of one of its lanes.
void solidPoints(const Metric&, const FrameData&, const ColoredHits&, Row (&point)[3], Row (&normal)[3]);

}  // namespace gluray::render
