// Maps GLX drawables to X windows. Any thread.
#pragma once
#include <cstdint>

namespace gluray::intercept {

/// Reports that GLX created a GLX name for an X window.
void glxWindowMade(uintptr_t name, uintptr_t window) noexcept;
/// Reports that GLX destroyed a GLX name.
void glxWindowGone(uintptr_t name) noexcept;
/// The X id of a GLX drawable.
uintptr_t windowOf(uintptr_t drawable) noexcept;

}  // namespace gluray::intercept
