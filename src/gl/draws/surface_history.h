// What earlier draws tell about later ones: surfaces drawn in several passes, coplanar surfaces, and
// triangles too large for rays. A part of each Context, GL thread.
#pragma once
#include "gl/draws/coplanar_surfaces.h"
#include "gl/draws/multipass_surfaces.h"
#include "gl/draws/ray_precision.h"

namespace gluray::gl {

struct SurfaceHistory {
  MultipassSurfaces passes;
  CoplanarSurfaces coplanar;
  RayPrecision precision;
};

}  // namespace gluray::gl
