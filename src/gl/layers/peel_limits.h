// How many dual depth peels show all layers, and what programs count meanwhile to know when to end. GL
// thread.
#pragma once
#include "base/image.h"

#include <cstdint>
#include <optional>

namespace gluray::gl {

/// Pixels of the farthest layers that peel number `peel` writes, from 1: the first one finds the opaque depth
/// in the place of the farthest layer, and a layer that is nearest and farthest counts as nearest.
uint64_t writtenBehind(const LayerCounts& layers, uint32_t peel);

/// The same where it is sure that there are any; not where silhouettes decide.
std::optional<uint64_t> surelyWritten(const LayerCounts& layers, uint32_t peel);

/// Whether so many peels show all layers of a picture of `pixels` pixels: all but a thousandth, where
/// silhouettes decide.
bool showsAll(uint32_t peels, const LayerCounts& layers, uint64_t pixels);

}  // namespace gluray::gl
