// Chooses the quality of acceleration structures: of the first one that a mesh gets, and whether to build a
// better one later. Pure functions; any thread.
#pragma once
#include "settings/settings.h"

#include <cstddef>
#include <cstdint>

namespace gluray::accel {

/// Bytes that may still be allocated. Asking takes some 0.1 ms.
using FreeMemory = size_t (*)();

/// What waits for structures of its own.
struct Waiting {
  uint64_t triangles = 0;
  uint64_t inBlocks = 0;  // of those, in meshes that fast structures hold as triangle blocks
};

/// Quality of the first structure of a mesh of `triangles`. `wanted` is the user's setting, `waiting` all
/// that waits for structures, this mesh included. With `automatic`, structures may take half of the free
/// memory. Large geometry gets `fast` structures where it is made of triangle blocks (triangle_blocks.h), or
/// where better structures fit beside the fast ones. Otherwise it gets the best quality that fits, in the end
/// `least`.
BvhQuality firstQuality(BvhQuality wanted, uint64_t triangles, const Waiting& waiting, FreeMemory freeMemory);

/// The same where an attempt has run out of memory.
BvhQuality thriftyQuality(BvhQuality wanted, uint64_t triangles);

/// Whether a structure of quality `held`, used in `frames` frames, is worth building again as `full`.
bool worthRefining(BvhQuality wanted, BvhQuality held, uint64_t frames);

/// Whether the full structure can be built while the fast one stays: it may take two fifths of the free
/// memory.
bool roomToRefine(uint64_t triangles, FreeMemory freeMemory);

}  // namespace gluray::accel
