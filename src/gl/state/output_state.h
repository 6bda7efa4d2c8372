// What stands between a fragment program's outputs and the framebuffer. GL thread.
#pragma once
#include "gl/real.h"
#include "gl/state/state.h"

namespace gluray::gl {

/// Why state of later versions and extensions, that hardly any program sets, rules tracing out.
Reason rareReason(const RealGl& real, const RareState& has);

/// Whether what a fragment program writes is what the framebuffer has afterwards.
bool writesThrough(const RealGl& real, const RareState& has);

/// Whether of all that is written to a pixel the framebuffer keeps the largest, channel by channel.
bool keepsLargest(const RealGl& real, const RareState& has);

/// Whether fragments are tested for depth, leave none, and add their colours to those of two draw buffers of
/// floats, while the first's alpha becomes the product of what they let through.
bool addsUp(const RealGl& real, const RareState& has, const RasterState& raster);

}  // namespace gluray::gl
