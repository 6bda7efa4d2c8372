// Keeps images of windows for the control thread, read from the real OpenGL. GL thread.
#pragma once
#include "intercept/contexts/context_record.h"
#include "intercept/windows/window_images.h"

#include <GL/gl.h>

namespace gluray::intercept {

/// Call before a swap, with all draws flushed and the context current: reads `buffer` of the window if an
/// image is wanted. Restores all state.
void keepBuffer(Record& record, GLenum buffer, ShownFrame shown) noexcept;

}  // namespace gluray::intercept
