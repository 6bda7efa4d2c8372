// Which acceleration structure a mesh gets first, and which it deserves later. Pure functions; any thread.
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
  uint64_t inRuns = 0;  // of those, in meshes that fast structures hold as runs (clusters.h)
};

/// Quality of the structure that a mesh of `triangles` gets for its first picture when the user wants
/// `wanted` and `waiting`, this mesh included, waits. For `automatic`, half of the free memory may be taken,
/// the rest being the program's: much geometry is built fast, if it is as runs of triangles (clusters.h) or
/// where the better structures fit beside the fast ones; otherwise as the best that fits, in the end as runs
/// that are longer.
BvhQuality firstQuality(BvhQuality wanted, uint64_t triangles, const Waiting& waiting, FreeMemory freeMemory);

/// The same where an attempt has run out of memory.
BvhQuality thriftyQuality(BvhQuality wanted, uint64_t triangles);

/// Whether a structure of quality `held`, used in `frames` frames, is worth building again as `full`.
bool worthRefining(BvhQuality wanted, BvhQuality held, uint64_t frames);

/// Whether the full structure can be built while the fast one stays: it may take two fifths of the free
/// memory.
bool roomToRefine(uint64_t triangles, FreeMemory freeMemory);

}  // namespace gluray::accel
