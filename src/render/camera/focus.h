// What the lens is focused at. Asked once a frame on the calling thread.
#pragma once
#include "accel/world.h"
#include "render/camera/ray_setup.h"
#include "scene/snapshot.h"

namespace gluray::render {

/// The distance in focus, along the axis from the lens: what settings.camera says, or that of the surface at
/// its focus position, or if none is there, of the middle of the world's bounds. Not positive: there is
/// nothing that a lens could focus at. `rays`: of the viewer, in the world that holds the snapshot; `visible`
/// accepts the hits that the viewer sees. Throws std::runtime_error where a matrix cannot be inverted.
double distanceInFocus(const scene::Snapshot&, const RaySetup& rays, const accel::World&,
                       const accel::HitFilter& visible);

}  // namespace gluray::render
