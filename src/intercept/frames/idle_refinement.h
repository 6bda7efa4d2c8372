// Refines images in windows while their programs are idle. GL thread.
#pragma once
#include <cstdint>

struct _XDisplay;  // Xlib's Display, without its header's macros

namespace gluray::intercept {

/// Call when a swap of `drawable` has shown a frame: refines it while the program draws nothing. Without a
/// display (EGL) its images are only remembered for reads.
void refineShown(_XDisplay* display, uintptr_t drawable) noexcept;

}  // namespace gluray::intercept
