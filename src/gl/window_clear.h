// Clears of windows that may be made later: whether they clear everything, and what they need. GL thread.
#pragma once
#include "gl/extensions.h"
#include "gl/presenter.h"
#include "gl/real.h"

namespace gluray::gl {

/// Whether glClear(mask) now clears all of the window, however large, in the buffers of `mask`.
bool clearsWindow(const RealGl& real, const RareState& has, GLbitfield mask);

/// glClear(mask) with the values of now.
WindowClear windowClear(const RealGl& real, GLbitfield mask);

}  // namespace gluray::gl
