// Automatic exposure (setting auto-exposure): measures how bright effects of light make the lit surfaces of a
// view, compared with the program's own image. Called once a frame, on the thread that traces.
#pragma once
#include "accel/world.h"
#include "parallel/arena.h"
#include "scene/snapshot.h"

#include <optional>

namespace gluray::render {

/// Whether the settings ask for automatic exposure of this batch, and change its light.
bool wantsMeter(const scene::Snapshot&);

/// The factor of linear light with which the mean luminance (of displayed values) of lit surfaces is that of
/// the program's own image, within kMaxStops. Traces small images of the view with and without effects of
/// light; depends on nothing but the snapshot. None if no lit surface is visible, and for layers. `world`
/// holds the snapshot's instances. Throws as traceImage().
std::optional<float> meteredExposure(const scene::Snapshot&, const accel::World& world, Arena&);

inline constexpr float kMaxStops = 3;

}  // namespace gluray::render
