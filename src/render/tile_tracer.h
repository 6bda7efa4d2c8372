// Traces a snapshot into an image with all threads of an arena. Called by frame::Renderer, one frame at a
// time.
#pragma once
#include "accel/world.h"
#include "base/image.h"
#include "parallel/arena.h"
#include "render/moving/film_source.h"
#include "render/moving/light_history.h"
#include "render/tiles/tile_source.h"
#include "render/tiles/tiles.h"
#include "scene/snapshot.h"

namespace gluray::render {

/// Whether the snapshot's settings ask for more than the local look.
bool hasLight(const scene::Snapshot&);

/// Sets every pixel of the snapshot's region to a miss, as the null renderer does. `image` takes the region's
/// shape.
void clearImage(const scene::Snapshot&, Image& image);

class RemoteSurfaces;

struct TraceOptions {
  // Of frames of an animation (scene::LightSampling::Mode::moving).
  LightHistories* histories = nullptr;  // null: earlier frames are not used
  MovingRays rays;
  Interrupt interrupt = {};  // of all other frames
  // Null: this process traces all tiles. Otherwise those that it hands out, moving frames like others unless
  // it is `film`, too.
  TileSource* source = nullptr;
  FilmSource* film = nullptr;
  // Null: all surfaces of the view are here. Only with a source, and where the settings ask for light.
  RemoteSurfaces* remote = nullptr;
  // With remote surfaces: called when the picture is whole, before other processes get their last answers;
  // `seconds`: since all processes had begun.
  std::function<void(double seconds)> traced = {};
  bool averages = true;  // pixels average several samples where settings ask for it; only false with a source
};

/// Computes colour and window depth of every pixel of the snapshot's region, for the instances that `world`
/// holds. `image` takes the region's shape, one plane per sample. Throws std::runtime_error if a matrix
/// cannot be inverted, std::bad_alloc. False: interrupted; the image is then undefined.
/// With a source, images of averages that cannot be composited are not traced anew.
bool traceImage(const scene::Snapshot&, const accel::World& world, Arena&, Image& image,
                const TraceOptions& = {});

}  // namespace gluray::render
