// Computes the focus distance. Called once a frame on the calling thread.
#pragma once
#include "accel/world.h"
#include "render/camera/ray_setup.h"
#include "scene/snapshot.h"

namespace gluray::render {

/// Returns the focus distance along the axis from the lens: settings.camera.focus, or if that is 0, the
/// distance of the surface at the focus position, or if there is no surface, of the centre of the world's
/// bounds. A result that is not positive means that there is nothing to focus on. `rays`: primary rays in the
/// world that holds the snapshot; `visible` accepts hits that are visible to the viewer. Throws
/// std::runtime_error if a matrix cannot be inverted.
double distanceInFocus(const scene::Snapshot&, const RaySetup& rays, const accel::World&,
                       const accel::HitFilter& visible);

}  // namespace gluray::render
