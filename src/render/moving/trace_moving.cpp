#include "render/moving/trace_moving.h"

#include "base/log.h"
#include "base/timeline.h"
#include "render/integrators/direct_look.h"
#include "render/kernels.h"
#include "render/moving/collector.h"
#include "render/moving/filter.h"
#include "render/moving/tiles_around.h"

namespace gluray::render {

bool isMoving(const FrameData& frame) {
  const scene::Snapshot& snapshot = *frame.snapshot;
  const bool plain = !snapshot.layers && !frame.averages && frame.samplePositions.size() == 1;
  return snapshot.lightSampling.mode == scene::LightSampling::Mode::moving && plain &&
         frame.eyeRays.linear.usable;
}

bool traceMoving(FrameData& frame, LightHistories* kept, const MovingRays& rays) {
  LightHistories own;
  LightHistories& histories = kept ? *kept : own;
  LightHistory& history = histories.of(frame.snapshot->view);
  MovingFrame moving;
  moving.index = history.index(), moving.rays = rays;
  frame.moving = &moving;
  const std::unique_ptr<const Integrator> integrator = makeIntegrator(frame);
  frame.moving = nullptr;
  const auto* factors = dynamic_cast<const FactorIntegrator*>(integrator.get());
  if (!factors) return false;
  try {
    history.begin(frame, *factors, moving);
  } catch (const std::bad_alloc&) {
    log::once(log::Level::warning, "moving light",
              "no memory to smooth the light of moving frames: they take all samples and are slower");
    histories.clear();
    return false;
  }
  if (!moving.space.usable) return false;
  const std::unique_ptr<const DirectLook> direct = makeDirectLook(frame);
  const Metric metric(frame);
  const Collector collector(frame, moving, *factors, metric);
  frame.moving = &moving, frame.direct = direct.get();
  frame.integrator = factors, frame.collector = &collector, frame.hits = moving.hits;
  TilesAround waiting(*frame.image);
  eachTile(Tiles(*frame.image, kTileSize), "tiles", {}, [&](const Tile& tile) {
    moving.film->clear(tile.x0, tile.y0, tile.x1, tile.y1);
    WaitingPoints points{};
    traceTile(frame, tile, &points);
    collector.finish(points);
    waiting.finish(tile, [&](const Tile& ready) {
      const timeline::Span span("relit tiles", 1, true);
      TileFactors smooth;
      filterTile(moving, ready, smooth);
      relightTile(frame, ready, smooth);
    });
  });
  frame.moving = nullptr, frame.integrator = nullptr, frame.direct = nullptr;
  frame.collector = nullptr, frame.hits = nullptr;
  history.finish();
  return true;
}

}  // namespace gluray::render
