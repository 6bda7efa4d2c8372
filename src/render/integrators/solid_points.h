// Points of impostors in eye space. Part of the integrators' point maker (points.inl.h); any thread.
#pragma once
#include "render/integrators/integrator.h"
#include "render/integrators/metric.h"

namespace gluray::render {

/// Eye-space points and unit normals of the group's lanes, on the solids that secondary rays hit
/// (accel/impostors/solid.h). The drawn pixels of beads, tubes, splats and half spheres lie inside or in
/// front of these solids. Lanes outside the group repeat one of its lanes.
void solidPoints(const Metric&, const FrameData&, const ColoredHits&, Row (&point)[3], Row (&normal)[3]);

}  // namespace gluray::render
