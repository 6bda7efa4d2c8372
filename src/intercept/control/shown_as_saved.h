// What a program shows, as a scene that can be saved. Control thread.
#pragma once
#include "gl/objects/shown_frames.h"
#include "intercept/control/shown_scene.h"
#include "saved/scene/saved_scene.h"

namespace gluray::intercept {

/// The batches of the frame, without the window's pixels.
saved::SavedScene savedScene(const gl::ShownFrame& frame, const ShownWindowPlaces& window);

}  // namespace gluray::intercept
