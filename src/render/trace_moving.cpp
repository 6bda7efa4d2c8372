#include "render/trace_moving.h"

#include "base/clock.h"
#include "base/log.h"
#include "base/timeline.h"
#include "render/effects/make_integrator.h"
#include "render/ground/catcher.h"
#include "render/integrators/direct_look.h"
#include "render/kernels/kernels.h"
#include "render/moving/collector.h"
#include "render/moving/filter.h"
#include "render/remote/remote_surfaces.h"
#include "render/tiles/tile.h"
#include "render/tiles_around.h"

namespace gluray::render {

bool isMoving(const FrameData& frame) {
  const scene::Snapshot& snapshot = *frame.snapshot;
  const bool plain = !snapshot.layers && !frame.averages && frame.samplePositions.size() == 1;
  return snapshot.lightSampling.mode == scene::LightSampling::Mode::moving && plain &&
         frame.eyeRays.linear.usable;
}

namespace {

/// What a moving frame is traced with.
struct Pass {
  FrameData& frame;
  const MovingFrame& moving;
  const Collector& collector;

  /// Puts a tile's hits, surfaces and visibility into the buffers.
  void collect(const Tile& tile) const {
    moving.visibility->clear(tile.x0, tile.y0, tile.x1, tile.y1);
    WaitingPoints points{};
    traceTile(frame, tile, &points);
    collector.finish(points);
  }
  /// The same, without the hits that other processes hide; later, if their depths are to come.
  void collectDepthsFirst(const Tile& tile) const {
    RemoteSurfaces& remote = *frame.remote;
    if (!remote.hasDepths()) {
      moving.visibility->clear(tile.x0, tile.y0, tile.x1, tile.y1);
      if (!frame.drawn.contains(tile)) return clearTile(tile, *frame.image);
      traceEyeRays(frame, tile);
      if (remote.exchangeDepths(tile, *frame.image)) return;
    }
    WaitingPoints points{};
    lightSeen(frame, tile, remote.hidden(tile, *frame.image), &points);
    collector.finish(points);
  }
  /// Colours the hits of a tile whose neighbours are in the buffer.
  void color(const Tile& tile) const {
    if (frame.seen && !frame.drawn.contains(tile)) return;
    const timeline::Span span("relit tiles", 1, true);
    TileVisibility smooth;
    filterTile(moving, tile, smooth);
    relightTile(frame, tile, smooth);
  }
};

void traceAll(const Pass& pass) {
  const Image& image = *pass.frame.image;
  TilesAround waiting(image);
  eachTile(Tiles(image, kTileSize), "tiles", {}, [&](const Tile& tile) {
    pass.collect(tile);
    waiting.finish(tile, [&](const Tile& ready) { pass.color(ready); });
  });
}

/// False: the frame was given up.
bool traceShared(const Pass& pass, MovingTileSource& source) {
  const Tiles tiles(*pass.frame.image, kTileSize);
  VisibilityBuffer& buffer = *pass.moving.visibility;
  source.begin(*pass.frame.image);
  eachTileFrom(
      "tiles", [&] { return source.nextTile(); },
      [&](int tile) {
        const double start = nowSeconds();
        if (pass.frame.seen)
          pass.collectDepthsFirst(tiles.at(tile));
        else
          pass.collect(tiles.at(tile));
        source.collected(buffer, tile, nowSeconds() - start);
      });
  if (!source.complete(buffer)) return false;
  eachTileFrom(
      "relit tiles", [&] { return source.nextToColor(); },
      [&](int tile) {
        const double start = nowSeconds();
        pass.color(tiles.at(tile));
        source.done(tile, nowSeconds() - start, false);
      });
  return true;
}

}  // namespace

bool traceMoving(FrameData& frame, LightHistories* kept, const MovingRays& rays, MovingTileSource* source) {
  LightHistories own;
  LightHistories& histories = kept ? *kept : own;
  LightHistory& history = histories.historyOf(frame.snapshot->view);
  MovingFrame moving;
  if (frame.snapshot->lightSampling.anew) history.forget();
  moving.index = source ? source->index(history.index()) : history.index(), moving.rays = rays;
  frame.moving = &moving;
  const std::unique_ptr<const Integrator> integrator = makeIntegrator(frame);
  frame.moving = nullptr;
  const auto* visibility = dynamic_cast<const VisibilityIntegrator*>(integrator.get());
  if (!visibility) return false;
  try {
    history.begin(frame, *visibility, moving);
  } catch (const std::bad_alloc&) {
    log::once(
        log::Level::warning, "moving light",
        "out of memory: frames with light effects trace all samples while the camera moves, and are slower");
    histories.clear();
    return false;
  }
  if (!moving.space.usable) return false;
  const std::unique_ptr<const DirectLook> direct = makeDirectLook(frame);
  const Metric metric(frame);
  const Collector collector(frame, moving, *visibility, metric);
  frame.moving = &moving, frame.direct = direct.get();
  frame.integrator = visibility, frame.collector = &collector, frame.hits = moving.hits;
  HitBuffer* const seen = frame.seen;
  if (seen) frame.seen = moving.hits;
  if (!source) frame.caughtOcclusion = caughtOcclusionOf(frame, *visibility);
  bool whole = true;
  if (source)
    whole = traceShared({frame, moving, collector}, *source);
  else
    traceAll({frame, moving, collector});
  frame.moving = nullptr, frame.integrator = nullptr, frame.direct = nullptr;
  frame.collector = nullptr, frame.hits = nullptr, frame.caughtOcclusion.reset();
  frame.seen = seen;
  if (whole)
    history.finish();
  else
    history.abandon();
  return true;
}

}  // namespace gluray::render
