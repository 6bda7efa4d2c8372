// What the lens is focused at. Asked once a frame on the calling thread.
#pragma once
#include "render/frame_data.h"

namespace gluray::render {

/// The distance in focus, along the axis from the lens: what settings.camera says, or that of the surface at
/// its focus position, or if none is there, of the middle of the world's bounds. Not positive: there is
/// nothing that a lens could focus at. Throws std::runtime_error where a matrix cannot be inverted.
double distanceInFocus(const FrameData&);

}  // namespace gluray::render
