// State that decides how a fragment shader's outputs reach the framebuffer. GL thread.
#pragma once
#include "gl/real/real.h"
#include "gl/state/state.h"

namespace gluray::gl {

/// The reason why rarely used state of later versions and extensions prevents tracing; Reason::traced if it
/// does not.
Reason rareReason(const RealGl& real, const RareState& has);

/// Whether the framebuffer gets a fragment shader's outputs unchanged: no depth test, blending or culling.
bool writesThrough(const RealGl& real, const RareState& has);

/// Whether each channel keeps the largest value that was written: GL_MAX blending without depth test.
bool keepsLargest(const RealGl& real, const RareState& has);

/// Whether blending sums layers: fragments are depth-tested without writing depth, add their colours to two
/// float draw buffers, and multiply the buffers' alpha by 1 - their own alpha. The alpha of the first buffer
/// becomes the product of the fragments' transmittances.
bool addsUp(const RealGl& real, const RareState& has, const RasterState& raster);

}  // namespace gluray::gl
