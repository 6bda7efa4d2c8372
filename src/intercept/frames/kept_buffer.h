// Reads images of windows from the real OpenGL, for the control thread. GL thread.
#pragma once
#include "intercept/contexts/context_record.h"
#include "intercept/windows/window_images.h"

#include <GL/gl.h>

namespace gluray::intercept {

/// Call before a swap, with all draws flushed and the context current: reads `buffer` of the window if an
/// image is requested. Restores all state.
void keepBuffer(Record& record, GLenum buffer, ShownFrame shown) noexcept;

}  // namespace gluray::intercept
