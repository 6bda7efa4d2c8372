// Blending of colours that a framebuffer of eight bits a channel holds. Called by the kernels on tracing
// threads.
#pragma once
#include "scene/blending.h"
#include "scene/snapshot.h"

#include <cstdint>

namespace gluray::render {

/// What a fragment of colour `source` makes of a pixel that is `there`, both RGBA8 with red in the lowest
/// byte, rounded to eight bits. Channels that `writes` leaves out stay. Source: GL 2.1, 4.1.8.
uint32_t blended(const scene::Blending&, const scene::ColorWrites& writes, uint32_t source, uint32_t there);

}  // namespace gluray::render
