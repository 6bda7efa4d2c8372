// How many dual depth peels show all layers, and the pixel counts by which programs decide when to stop
// peeling. Called by LayerDraws, GL thread.
#pragma once
#include "base/image.h"

#include <cstdint>
#include <optional>

namespace gluray::gl {

/// Number of pixels whose farthest layer is written by peel number `peel`, counted from 1. The first peel
/// finds the opaque depth instead of a farthest layer. A layer that is both nearest and farthest counts as
/// nearest.
uint64_t writtenBehind(const LayerCounts& layers, uint32_t peel);

/// writtenBehind(), or nullopt if that number is so small that rounding at silhouettes could make it 0.
std::optional<uint64_t> surelyWritten(const LayerCounts& layers, uint32_t peel);

/// Whether `peels` peels show all layers of an image of `pixels` pixels. Ignores one pixel in a thousand,
/// because silhouettes may differ.
bool showsAll(uint32_t peels, const LayerCounts& layers, uint64_t pixels);

}  // namespace gluray::gl
