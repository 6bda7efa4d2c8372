// Clears of whole framebuffers. GL thread.
#pragma once
#include "gl/extensions.h"
#include "gl/real.h"

namespace gluray::gl {

/// Whether a glClear of colour and depth now writes all of both, within the scissor box, and depth 1.
bool clearsAll(const RealGl& real, const RareState& has);

}  // namespace gluray::gl
