// What stands between a fragment program's outputs and the framebuffer. GL thread.
#pragma once
#include "gl/real.h"
#include "gl/state.h"

namespace gluray::gl {

/// Whether what a fragment program writes is what the framebuffer has afterwards.
bool writesThrough(const RealGl& real, const RareState& has);

/// Whether of all that is written to a pixel the framebuffer keeps the largest, channel by channel.
bool keepsLargest(const RealGl& real, const RareState& has);

}  // namespace gluray::gl
