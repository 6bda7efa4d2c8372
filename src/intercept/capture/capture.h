// Saves scenes of frames for the launcher (gluray run --shot). A frame is what the program shows: a swap, a
// flush of a window with one buffer, or, in programs that show no window, a picture that they read. Without
// a plan, a frame costs the read of a constant. GL threads.
#pragma once
#include "intercept/contexts/context_record.h"
#include "scene/region.h"

#include <GL/gl.h>

namespace gluray::intercept {

/// Call once, before the first context is created: reads the plan from the environment.
void planCapture();
/// Whether frames are to be captured: then windows show them by the program's own swaps, at once, and are not
/// refined.
bool capturing() noexcept;

/// Call before a frame is shown, with all draws flushed: keeps the colours of the window's `buffer`.
void captureShowing(Record& record, GLenum buffer) noexcept;
/// Call after it was shown, and the next frame has begun.
void captureShown() noexcept;
/// Call after the program has read a picture from the bound read framebuffer, `region` in pixels.
void captureRead(Record& record, const scene::Region& region) noexcept;

}  // namespace gluray::intercept
