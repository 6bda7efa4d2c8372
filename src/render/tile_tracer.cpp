#include "render/tile_tracer.h"

#include "base/log.h"
#include "base/timeline.h"
#include "render/float_guard.h"
#include "render/integrators/direct_look.h"
#include "render/integrators/integrator.h"
#include "render/kernels.h"
#include "render/moving/collector.h"
#include "render/moving/filter.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <vector>

namespace gluray::render {
namespace {

constexpr int kLargestSide = 65536;  // pixels; larger than any framebuffer

Planes planesOf(const scene::Snapshot& snapshot, bool averages) {
  const bool sums = snapshot.layers && snapshot.layers->of == scene::Layers::Of::sums;
  const Planes planes = sums ? Image::kSums : snapshot.wideColors ? Image::kWide : Image::kPicture;
  return averages ? planes | Plane::centerDepth : planes;
}

bool areDrawn(const scene::Layers* layers) { return layers && layers->of == scene::Layers::Of::drawn; }

/// Whether pixels average more samples than the framebuffer has. Layers blended with the framebuffer's
/// colours in the order of drawing use the framebuffer's samples.
bool wantsAverages(const scene::Snapshot& snapshot) {
  return snapshot.samples <= 1 && snapshot.settings.spp > 1 && !areDrawn(snapshot.layers.get());
}

/// Whether the layers' arrays have one element per pixel.
bool arePixels(const scene::Layers& layers, size_t pixels) {
  return layers.opaqueDepth.size() == pixels && (!areDrawn(&layers) || layers.colors.size() == pixels);
}

void shapeImage(const scene::Snapshot& snapshot, Image& image, bool averages) {
  const scene::Region& region = snapshot.region;
  if (region.width <= 0 || region.height <= 0) throw std::runtime_error("the region to trace is empty");
  if (region.width > kLargestSide || region.height > kLargestSide || snapshot.samples > 64) {
    throw std::runtime_error("the region to trace is larger than any framebuffer");
  }
  const size_t pixels = static_cast<size_t>(region.width) * static_cast<size_t>(region.height);
  if (snapshot.layers && (snapshot.samples > 1 || !arePixels(*snapshot.layers, pixels))) {
    throw std::runtime_error("layers need one sample a pixel, and the depth of what is opaque for each");
  }
  image.x = region.x;
  image.y = region.y;
  image.resize(region.width, region.height, std::max(snapshot.samples, 1), planesOf(snapshot, averages));
  image.layers = {};
}

void fillWithMisses(Image& image) {
  std::fill(image.color.begin(), image.color.end(), image.isAverages() ? 0u : image.missColor);
  std::fill(image.depth.begin(), image.depth.end(), Image::kMiss);
  std::fill(image.centerDepth.begin(), image.centerDepth.end(), Image::kMiss);
  std::fill(image.wideColor.begin(), image.wideColor.end(), 0.0f);
  std::fill(image.transmittance.begin(), image.transmittance.end(), 1.0f);
}

}  // namespace

bool hasLight(const scene::Snapshot& snapshot) { return wantsIntegrator(snapshot.settings); }

void clearImage(const scene::Snapshot& snapshot, Image& image) {
  shapeImage(snapshot, image, wantsAverages(snapshot));
  fillWithMisses(image);
}

namespace {

/// The tiles of an image, row by row.
struct Tiles {
  int width, height, columns, rows;
  explicit Tiles(const Image& image)
      : width(image.width),
        height(image.height),
        columns((width + kTileSize - 1) / kTileSize),
        rows((height + kTileSize - 1) / kTileSize) {}
  Tile at(int index) const {
    const int x = index % columns * kTileSize, y = index / columns * kTileSize;
    return {x, y, std::min(x + kTileSize, width), std::min(y + kTileSize, height)};
  }
};

/// Calls work(tile) for all of an image's tiles, on all threads.
template <class Work>
void eachTile(const Image& image, const char* name, const Work& work) {
  const Tiles tiles(image);
  tbb::parallel_for(0, tiles.columns * tiles.rows, [&](int index) {
    const FloatGuard guard;
    timeline::nameThread("tracing");
    const timeline::Span span(name, 1, true);
    work(tiles.at(index));
  });
}

/// Tells when all of a tile's neighbours are finished, so that its surroundings can be read while they are in
/// the caches.
class TilesAround {
 public:
  explicit TilesAround(const Image& image)
      : tiles_(image), unfinished_(static_cast<size_t>(tiles_.columns) * static_cast<size_t>(tiles_.rows)) {
    for (int y = 0; y < tiles_.rows; ++y)
      for (int x = 0; x < tiles_.columns; ++x) around(x, y, [&](int, int) { ++counterOf(x, y); });
  }
  /// Calls ready(tile) for each tile that waited for this one alone. Any thread.
  template <class Ready>
  void finish(const Tile& tile, const Ready& ready) {
    around(tile.x0 / kTileSize, tile.y0 / kTileSize, [&](int x, int y) {
      if (--counterOf(x, y) == 0) ready(tiles_.at(y * tiles_.columns + x));
    });
  }

 private:
  std::atomic<int>& counterOf(int x, int y) {
    return unfinished_[static_cast<size_t>(y) * static_cast<size_t>(tiles_.columns) + static_cast<size_t>(x)];
  }
  template <class Each>
  void around(int x, int y, const Each& each) const {
    for (int row = std::max(y - 1, 0); row <= std::min(y + 1, tiles_.rows - 1); ++row)
      for (int column = std::max(x - 1, 0); column <= std::min(x + 1, tiles_.columns - 1); ++column)
        each(column, row);
  }
  Tiles tiles_;
  std::vector<std::atomic<int>> unfinished_;  // of each tile and its neighbours
};

/// Whether the pixels of a frame of an animation have one nearest hit each, whose factors can be smoothed.
bool isMoving(const scene::Snapshot& snapshot, const FrameData& frame) {
  const bool plain = !snapshot.layers && !frame.averages && frame.samplePositions.size() == 1;
  return snapshot.lightSampling.mode == scene::LightSampling::Mode::moving && plain &&
         frame.eyeRays.linear.usable;
}

/// Traces all factors, smooths them, and then colours the hits. False, with nothing traced, if it cannot.
bool traceMoving(FrameData& frame, const MovingOptions& options) {
  LightHistories own;
  LightHistories& histories = options.histories ? *options.histories : own;
  LightHistory& history = histories.of(frame.snapshot->view);
  MovingFrame moving;
  moving.index = history.index(), moving.rays = options.rays;
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
  eachTile(*frame.image, "tiles", [&](const Tile& tile) {
    moving.film->clear(tile.x0, tile.y0, tile.x1, tile.y1);
    traceTile(frame, tile);
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

/// False if averages cannot be composited over the framebuffer: alpha is written but is no opacity.
bool traceTiles(const scene::Snapshot& snapshot, const accel::World& world, Image& image,
                const MovingOptions& options) {
  FrameData frame(snapshot, world, image);
  if (isMoving(snapshot, frame) && traceMoving(frame, options)) return true;
  const std::unique_ptr<const Integrator> integrator = makeIntegrator(frame);
  frame.integrator = integrator.get();
  const std::unique_ptr<const DirectLook> direct = makeDirectLook(frame);
  frame.direct = direct.get();
  eachTile(image, "tiles", [&](const Tile& tile) { traceTile(frame, tile); });
  for (size_t n = 0; n < LayerCounts::kMost; ++n)
    image.layers.open[n] = frame.layerCounts[0][n], image.layers.before[n] = frame.layerCounts[1][n];
  return snapshot.layers || !frame.seenThrough.load();
}

}  // namespace

void traceImage(const scene::Snapshot& snapshot, const accel::World& world, Arena& arena, Image& image,
                const MovingOptions& options) {
  if (world.empty()) return clearImage(snapshot, image);
  arena.execute([&] {
    if (wantsAverages(snapshot)) {
      shapeImage(snapshot, image, true);
      if (traceTiles(snapshot, world, image, options)) return;
    }
    shapeImage(snapshot, image, false);
    traceTiles(snapshot, world, image, options);
  });
}

}  // namespace gluray::render
