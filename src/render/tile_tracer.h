// Traces a snapshot into an image with every thread of an arena. Called by frame::Renderer, one frame at a
// time.
#pragma once
#include "accel/world.h"
#include "base/image.h"
#include "parallel/arena.h"
#include "scene/snapshot.h"

namespace gluray::render {

/// Makes every pixel of the snapshot's region a miss: what the null renderer shows. `image` takes the
/// region's shape.
void clearImage(const scene::Snapshot&, Image& image);

/// Colour and window depth of every pixel of the snapshot's region, for the instances that `world` holds.
/// `image` takes the region's shape, one plane a sample. Throws std::runtime_error where a matrix cannot be
/// inverted, std::bad_alloc.
void traceImage(const scene::Snapshot&, const accel::World& world, Arena&, Image& image);

}  // namespace gluray::render
