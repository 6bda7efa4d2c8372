// What is known of the surfaces drawn before, for draws that come: which were drawn in several passes, which
// lie in one plane, and which triangles are too large for rays. A part of each Context, GL thread.
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
