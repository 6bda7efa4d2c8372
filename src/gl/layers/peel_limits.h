// How many dual depth peels show all layers, and the pixel counts by which programs decide when to stop
// peeling. Called by LayerDraws, GL thread.
#pragma once
#include "base/image.h"

#include <cstdint>
#include <optional>

namespace gluray::gl {

/// Number of pixels of farthest layers that peel number `peel`, from 1, writes. The first peel finds the
/// opaque depth in place of a farthest layer; a layer that is both nearest and farthest counts as nearest.
uint64_t writtenBehind(const LayerCounts& layers, uint32_t peel);

/// writtenBehind(), or nullopt where it is so small that rounding at silhouettes could make it 0.
std::optional<uint64_t> surelyWritten(const LayerCounts& layers, uint32_t peel);

/// Whether `peels` peels show all layers of an image of `pixels` pixels. Ignores a thousandth of them, where
/// silhouettes may differ.
bool showsAll(uint32_t peels, const LayerCounts& layers, uint64_t pixels);

}  // namespace gluray::gl
