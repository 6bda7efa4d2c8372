// The hot loops, compiled for several instruction sets; the best for this processor is chosen at the first
// call.
#pragma once
#include "render/frame_data.h"

namespace gluray::render {

/// Traces and shades one tile of every sample plane. Any number of threads, on different tiles.
void traceTile(const FrameData&, const Tile&);

/// Name of the instruction set that traceTile uses, such as "AVX3".
const char* kernelTarget();

}  // namespace gluray::render
