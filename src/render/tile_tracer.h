// Traces a snapshot into an image with all threads of an arena. Called by frame::Renderer, one frame at a
// time.
#pragma once
#include "accel/world.h"
#include "base/image.h"
#include "parallel/arena.h"
#include "scene/snapshot.h"

#include <functional>

namespace gluray::render {

/// Sets every pixel of the snapshot's region to a miss, as the null renderer does. `image` takes the region's
/// shape.
void clearImage(const scene::Snapshot&, Image& image);

/// Whether tracing must stop; asked before each tile, on all tracing threads.
using Interrupt = std::function<bool()>;

/// Computes colour and window depth of every pixel of the snapshot's region, for the instances that `world`
/// holds. `image` takes the region's shape, one plane per sample. Throws std::runtime_error if a matrix
/// cannot be inverted, std::bad_alloc. False: interrupted; the image is then undefined.
bool traceImage(const scene::Snapshot&, const accel::World& world, Arena&, Image& image,
                const Interrupt& interrupt = {});

}  // namespace gluray::render
