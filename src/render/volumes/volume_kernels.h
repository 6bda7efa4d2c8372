// Casts the rays of volumes, compiled for several instruction sets; the first call chooses the best for this
// processor. Called on tracing threads.
#pragma once
#include "render/tiles/tile.h"
#include "render/volumes/volume_frame.h"

namespace gluray::render {

/// Writes colour, premultiplied by opacity, and depth of the tile's pixels: those of the entry, or
/// Image::kMiss where nothing is shown. Threads may run it in parallel on different tiles.
void castTile(const VolumeFrame& frame, const Tile& tile);

/// Opacities, 0 .. 1, of `count` samples in texture space, which lie `step` apart along x; 0 for those that
/// are skipped. The frame needs no rays and no image; its volume is blended as VolumeBlend::composite.
void sampleRow(const VolumeFrame& frame, const glm::vec3& first, float step, int count, float* opacities);

}  // namespace gluray::render
