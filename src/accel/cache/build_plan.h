// Chooses the build quality of a mesh's first BLAS, and whether to rebuild it at full quality later. Called
// by BlasCache. Pure functions; any thread.
#pragma once
#include "settings/settings.h"

#include <cstddef>
#include <cstdint>

namespace gluray::accel {

/// Returns the bytes that may still be allocated. A call takes about 0.1 ms.
using FreeMemory = size_t (*)();

/// The meshes that have no BLAS yet.
struct Waiting {
  uint64_t triangles = 0;
  uint64_t inBlocks = 0;  // triangles of those meshes whose fast BLAS would have triangle blocks, in bundles
                          // or alone, as leaves
};

/// Quality of the first BLAS of a mesh of `triangles` triangles. `wanted` is the user's setting; `waiting`
/// includes this mesh. With `automatic`, the BLASes may take half of the free memory. Large geometry is built
/// `fast` if its leaves are bundles of triangle blocks, or blocks alone (accel/blocks), or if a full BLAS
/// fits beside the fast ones. Otherwise it gets the best of `full`, `compact` and `least` that fits.
BvhQuality firstQuality(BvhQuality wanted, uint64_t triangles, const Waiting& waiting, FreeMemory freeMemory);

/// The quality for a retry after a build ran out of memory.
BvhQuality thriftyQuality(BvhQuality wanted, uint64_t triangles);

/// Whether a BLAS of quality `held`, used in `frames` frames so far, is worth rebuilding as `full`.
bool worthRefining(BvhQuality wanted, BvhQuality held, uint64_t frames);

/// Whether a full BLAS can be built while the fast one stays: it may take two fifths of the free memory.
bool roomToRefine(uint64_t triangles, FreeMemory freeMemory);

}  // namespace gluray::accel
