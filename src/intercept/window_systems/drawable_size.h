// Size of a window, pixmap or pbuffer of an X server, and whether a window is mapped. Any thread.
#pragma once
#include <GL/glx.h>
#include <glm/glm.hpp>

namespace gluray::intercept {

/// Width and height in pixels from the X server (one round trip; two for drawables that only GLX knows). {0,
/// 0} if the drawable no longer exists or the client libraries are missing. Never calls the program's X error
/// handler.
glm::ivec2 drawableSize(Display* display, GLXDrawable drawable) noexcept;

/// Whether the X drawable is a mapped window (one round trip). Otherwise like drawableSize().
bool isMapped(Display* display, XID window) noexcept;

}  // namespace gluray::intercept
