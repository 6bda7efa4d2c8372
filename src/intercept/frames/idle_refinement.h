// Refines images in windows while their programs are idle. GL thread.
#pragma once
#include <cstdint>

struct _XDisplay;  // Xlib's Display, without its header's macros

namespace gluray::intercept {

/// Call when a swap of `drawable` has shown a frame: refines the frame while the program is idle. Without a
/// display (EGL) its images are only kept for reads.
void refineShown(_XDisplay* display, uintptr_t drawable) noexcept;

}  // namespace gluray::intercept
