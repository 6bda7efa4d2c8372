// Traces a snapshot into an image with all threads of an arena. Called by frame::Renderer, one frame at a
// time.
#pragma once
#include "accel/world.h"
#include "base/image.h"
#include "parallel/arena.h"
#include "render/moving/light_history.h"
#include "scene/snapshot.h"

namespace gluray::render {

/// How frames of an animation are traced (scene::LightSampling::Mode::moving).
struct MovingOptions {
  LightHistories* histories = nullptr;  // null: earlier frames are not used
  MovingRays rays;
};

/// Whether the snapshot's settings ask for more than the local look.
bool hasLight(const scene::Snapshot&);

/// Sets every pixel of the snapshot's region to a miss, as the null renderer does. `image` takes the region's
/// shape.
void clearImage(const scene::Snapshot&, Image& image);

/// Computes colour and window depth of every pixel of the snapshot's region, for the instances that `world`
/// holds. `image` takes the region's shape, one plane per sample. Throws std::runtime_error if a matrix
/// cannot be inverted, std::bad_alloc.
void traceImage(const scene::Snapshot&, const accel::World& world, Arena&, Image& image,
                const MovingOptions& = {});

}  // namespace gluray::render
