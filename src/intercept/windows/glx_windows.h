// Maps GLX drawables to X windows. Any thread.
#pragma once
#include <cstdint>

namespace gluray::intercept {

/// GLX created, or destroyed, a GLX name of an X window.
void glxWindowMade(uintptr_t name, uintptr_t window) noexcept;
void glxWindowGone(uintptr_t name) noexcept;
/// The X server's name of a GLX drawable.
uintptr_t windowOf(uintptr_t drawable) noexcept;

}  // namespace gluray::intercept
