// What earlier draws tell about later ones: surfaces drawn in several passes, coplanar surfaces, triangles
// too large for rays, and what surrounds batches. A part of each Context, GL thread.
#pragma once
#include "gl/batch/view_scenes.h"
#include "gl/draws/coplanar_surfaces.h"
#include "gl/draws/multipass_surfaces.h"
#include "gl/draws/ray_precision.h"

namespace gluray::gl {

struct SurfaceHistory {
  MultipassSurfaces passes;
  CoplanarSurfaces coplanar;
  RayPrecision precision;
  ViewScenes views;
};

}  // namespace gluray::gl
