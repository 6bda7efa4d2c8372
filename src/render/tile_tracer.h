// Traces a snapshot into an image with all threads of an arena. Called by frame::Renderer, one frame at a
// time.
#pragma once
#include "accel/world.h"
#include "base/image.h"
#include "parallel/arena.h"
#include "render/media/medium_lattice.h"
#include "render/moving/light_history.h"
#include "render/moving/moving_tile_source.h"
#include "render/tiles/tile_source.h"
#include "render/tiles/tiles.h"
#include "scene/snapshot.h"

namespace gluray::render {

/// Whether the snapshot's settings use light effects.
bool hasLight(const scene::Snapshot&);

/// Sets every pixel of the snapshot's region to a miss, as the null renderer does. Resizes `image` to the
/// region.
void clearImage(const scene::Snapshot&, Image& image);

class RemoteSurfaces;

struct TraceOptions {
  // Of frames of an animation (scene::LightSampling::Mode::moving).
  LightHistories* histories = nullptr;  // null: earlier frames are not used
  MovingRays rays;
  Interrupt interrupt = {};  // of all other frames
  // Null: this process traces all tiles. Otherwise it traces the tiles of this source; moving frames are
  // traced as such only if the source is also movingSource.
  TileSource* source = nullptr;
  MovingTileSource* movingSource = nullptr;
  // Null: this process has all surfaces of the view. Only with a source and with light effects.
  RemoteSurfaces* remote = nullptr;
  // With remote surfaces: called when the image is complete, before other processes get their last answers;
  // `seconds`: time since all processes began.
  std::function<void(double seconds)> traced = {};
  std::vector<PlacedLattice> media = {};  // FrameData::media
  float litExposure = 1;                  // factor of linear light of lit surfaces
  bool averages = true;                   // pixels may average several samples; false only with a source
};

/// Computes colour and window depth of every pixel of the snapshot's region, for the instances in `world`.
/// Resizes `image` to the region, with one plane per sample. Throws std::runtime_error if a matrix cannot be
/// inverted, std::bad_alloc. Returns false if interrupted; the image is then undefined. With a source, images
/// of averages that cannot be composited are not traced again.
bool traceImage(const scene::Snapshot&, const accel::World& world, Arena&, Image& image,
                const TraceOptions& = {});

}  // namespace gluray::render
