// Hits on round surfaces that are a few pixels wide: tubes, lines, small balls. Their normals differ from
// pixel to pixel, so that history is found by their axes instead. Tracing threads.
#pragma once
#include "render/integrators/integrator.h"
#include "render/integrators/surface_points.h"
#include "render/moving/moving_frame.h"

namespace gluray::render {

/// Where the axes of narrow round surfaces are, by lane; eye space.
struct NarrowLanes {
  alignas(64) Row center[3];  // the point of the axis that is nearest to the surface's point
  alignas(64) Row axis[3];    // unit length; 0: a ball
  alignas(64) Row radius;     // 0: not a narrow round surface
  bool any = false;           // some lane has one
};

/// Sets the lanes of the group; others have radius 0. Only `any` is set if no lane is narrow.
void findNarrow(const FrameData&, const PixelSpace&, const ColoredHits&, const SurfacePoints&, NarrowLanes&);

}  // namespace gluray::render
