// Casts the rays of volumes, compiled for several instruction sets; the first call chooses the best for this
// processor. Called on tracing threads.
#pragma once
#include "render/tiles/tile.h"
#include "render/volumes/volume_frame.h"

namespace gluray::render {

/// Writes colour, premultiplied by opacity, and depth of the tile's pixels: those of the entry, or
/// Image::kMiss where nothing is shown. Threads may run it in parallel on different tiles.
void castTile(const VolumeFrame& frame, const Tile& tile);

}  // namespace gluray::render
