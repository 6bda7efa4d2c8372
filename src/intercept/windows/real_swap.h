// The types of a GLX swap, without Xlib's header and its macros.
#pragma once

struct _XDisplay;  // Xlib's Display

namespace gluray::intercept {

using XId = unsigned long;
using RealSwap = void (*)(_XDisplay*, XId drawable);

}  // namespace gluray::intercept
