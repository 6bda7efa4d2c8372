// History of draws that affects later draws: surfaces drawn in several passes, coplanar surfaces, triangles
// too large for rays, secondary scenes of batches, and objects. A part of each Context, GL thread.
#pragma once
#include "gl/history/coplanar_surfaces.h"
#include "gl/history/multipass_surfaces.h"
#include "gl/history/ray_precision.h"
#include "gl/objects/drawn_objects.h"
#include "gl/views/view_scenes.h"

namespace gluray::gl {

struct SurfaceHistory {
  MultipassSurfaces passes;
  CoplanarSurfaces coplanar;
  RayPrecision precision;
  ViewScenes views;
  DrawnObjects objects;

  /// Reports that the batch was traced, or surely will be.
  void traced(const BatchKey& key, const scene::SnapshotPtr& snapshot) noexcept {
    views.traced(key, snapshot);
    if (key.layers != BatchKey::Layers::visibility) objects.traced(key, snapshot);
  }
};

}  // namespace gluray::gl
