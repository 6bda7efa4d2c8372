// How large a window, pixmap or pbuffer of an X server is. Any thread.
#pragma once
#include <GL/glx.h>
#include <glm/glm.hpp>

namespace gluray::intercept {

/// Width and height in pixels, asked from the X server (one round trip; two for what only GLX knows). {0, 0}
/// where it does not exist any more or the libraries to ask with are missing. The program's X error handler
/// never hears of it.
glm::ivec2 drawableSize(Display* display, GLXDrawable drawable) noexcept;

}  // namespace gluray::intercept
