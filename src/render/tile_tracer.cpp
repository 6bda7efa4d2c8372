#include "render/tile_tracer.h"

#include "base/clock.h"
#include "base/log.h"
#include "render/effects/feature_integrators.h"
#include "render/effects/make_integrator.h"
#include "render/integrators/direct_look.h"
#include "render/integrators/integrator.h"
#include "render/kernels/kernels.h"
#include "render/moving/hit_buffer.h"
#include "render/remote/depths_first.h"
#include "render/remote/remote_surfaces.h"
#include "render/tiles/tile.h"
#include "render/tiles/tile_source.h"
#include "render/trace_moving.h"
#include "scene/effects.h"
#include "scene/failure.h"
#include "settings/samples.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace gluray::render {
namespace {

constexpr int kShortTile = 4;        // rows of tiles that may be interrupted; a multiple of 4
constexpr int kLargestSide = 65536;  // pixels; larger than any framebuffer

Planes planesOf(const scene::Snapshot& snapshot, bool averages) {
  const bool sums = snapshot.layers && snapshot.layers->of == scene::Layers::Of::sums;
  const Planes planes = sums ? Image::kSums : snapshot.wideColors ? Image::kWide : Image::kColorDepth;
  return averages ? planes | Plane::centerDepth : planes;
}

bool areDrawn(const scene::Layers* layers) { return layers && layers->of == scene::Layers::Of::drawn; }

/// Whether pixels have one sample although the settings ask for more.
bool movesAliased(const scene::Snapshot& snapshot) {
  return snapshot.lightSampling.aliased &&
         snapshot.lightSampling.mode == scene::LightSampling::Mode::moving && !snapshot.layers &&
         !hasOpenLens(snapshot.settings);
}

/// Whether pixels average more samples than the framebuffer has. Layers blended with the framebuffer's
/// colours in the order of drawing use the framebuffer's samples.
bool wantsAverages(const scene::Snapshot& snapshot) {
  if (areDrawn(snapshot.layers.get())) return false;
  if (isComposed(snapshot)) return true;
  if (movesAliased(snapshot)) return false;
  return averagesSamples(snapshot.settings, snapshot.samples);
}

/// Whether the layers' arrays have one element per pixel.
bool arePixels(const scene::Snapshot& snapshot, size_t pixels) {
  const scene::Layers& layers = *snapshot.layers;
  const size_t colors = snapshot.wideColors ? layers.floatColors.size() : layers.colors.size();
  return layers.opaqueDepth.size() == pixels && (!areDrawn(&layers) || colors == pixels);
}

void shapeImage(const scene::Snapshot& snapshot, Image& image, bool averages) {
  const scene::Region& region = snapshot.region;
  if (region.width <= 0 || region.height <= 0) throw scene::Untraceable("the region to trace is empty");
  if (region.width > kLargestSide || region.height > kLargestSide || snapshot.samples > 64) {
    throw scene::Untraceable("the region to trace is larger than any framebuffer");
  }
  const size_t pixels = static_cast<size_t>(region.width) * static_cast<size_t>(region.height);
  if (snapshot.layers && (snapshot.samples > 1 || !arePixels(snapshot, pixels))) {
    throw std::runtime_error("layers need one sample a pixel, and the depth of what is opaque for each");
  }
  image.x = region.x;
  image.y = region.y;
  image.resize(region.width, region.height, averages ? 1 : std::max(snapshot.samples, 1),
               planesOf(snapshot, averages));
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

bool hasLight(const scene::Snapshot& snapshot) { return scene::wantsLight(snapshot.settings); }

void clearImage(const scene::Snapshot& snapshot, Image& image) {
  shapeImage(snapshot, image, wantsAverages(snapshot));
  fillWithMisses(image);
}

namespace {

/// Whether the pass traces the tile. Masks of other shapes ask for all tiles.
bool isWanted(const scene::Snapshot& snapshot, const Tile& tile) {
  static_assert(scene::LightSampling::kTile == kTileSize);
  const auto* const tiles = snapshot.lightSampling.tiles.get();
  if (!tiles) return true;
  const Tiles all(snapshot.region.width, snapshot.region.height, kTileSize);
  const auto at = static_cast<size_t>(tile.y0 / kTileSize * all.columns + tile.x0 / kTileSize);
  return at >= tiles->size() || (*tiles)[at];
}

enum class Traced {
  whole,
  interrupted,
  seenThrough,  // averages cannot be composited over the framebuffer: alpha is written but is no opacity
};

/// Calls work(tile) for the tiles that the source hands out, on all threads.
template <class Work>
void eachTileOf(TileSource& source, const Image& image, accel::PageCache& pages, const Work& work) {
  source.begin(image);
  const Tiles tiles(image, kTileSize);
  eachTileFrom(
      "tiles", [&] { return source.nextTile(); },
      [&](int index) {
        const double start = nowSeconds();
        const accel::PageCache::Reader reader(pages);
        const bool seenThrough = work(tiles.at(index));
        source.done(index, nowSeconds() - start, seenThrough);
      });
}

/// Finds the other processes. `seen`: where hits may wait for their depths.
void beginRemote(FrameData& frame, HitBuffer& seen) {
  const char* const reason = reasonAgainstDepthsFirst(frame);
  if (!reason) frame.seen = &seen, frame.drawn = drawnPart(frame);
  if (reason && frame.snapshot->settings.depthFirst)
    log::once(log::Level::info, reason, std::string("this process lights also what others hide: ") + reason);
  frame.remote->begin(frame);
}

/// Lights what no other process hides, if its depths are there.
void traceDepthsFirst(const FrameData& frame, const Tile& tile) {
  RemoteSurfaces& remote = *frame.remote;
  if (!frame.drawn.contains(tile)) return clearTile(tile, *frame.image);
  if (!remote.hasDepths()) {
    traceEyeRays(frame, tile);
    if (remote.exchangeDepths(tile, *frame.image)) return;
  }
  lightSeen(frame, tile, remote.hidden(tile, *frame.image));
}

/// All tiles are traced; what this process has of the view goes on lighting the parts of others.
void holdRemote(const FrameData& frame, const TraceOptions& options, double start) {
  const auto whole = [&] {
    if (options.traced) options.traced(nowSeconds() - start);
  };
  if (frame.remote) frame.remote->hold(whole);
}

Traced traceTiles(const scene::Snapshot& snapshot, const accel::World& world, Image& image,
                  const TraceOptions& options) {
  std::optional<accel::PageCache::Reader> reader;  // tiles of a source have readers of their own
  if (!options.source) reader.emplace(world.pages());
  FrameData frame(snapshot, world, image);
  if (options.litExposure != 1) frame.exposeLit(options.litExposure);
  if (wantsFeatures(snapshot)) frame.dropTones();
  frame.remote = options.remote;
  frame.media = options.media;
  HitBuffer seen;
  if (frame.remote) beginRemote(frame, seen);
  const double start = nowSeconds();
  const bool smooths = !options.source || options.movingSource;
  if (smooths && isMoving(frame) && traceMoving(frame, options.histories, options.rays, options.movingSource))
    return holdRemote(frame, options, start), Traced::whole;
  const std::unique_ptr<const Integrator> integrator = makeIntegrator(frame);
  frame.integrator = integrator.get();
  const std::unique_ptr<const DirectLook> direct = makeDirectLook(frame);
  frame.direct = direct.get();
  if (options.source) {
    if (frame.seen) seen.resize(image.width, image.height, frame.edgesGrow);
    eachTileOf(*options.source, image, world.pages(), [&](const Tile& tile) {
      if (frame.seen) return traceDepthsFirst(frame, tile), false;
      traceTile(frame, tile);
      return !snapshot.layers && frame.seenThrough.load(std::memory_order_relaxed);
    });
  } else {
    const Tiles tiles(image, options.interrupt ? kShortTile : kTileSize);
    const bool whole = eachTile(tiles, "tiles", options.interrupt, [&](const Tile& tile) {
      if (isWanted(snapshot, tile)) traceTile(frame, tile);
    });
    if (!whole) return Traced::interrupted;
  }
  for (size_t n = 0; n < LayerCounts::kMax; ++n)
    image.layers.open[n] = frame.layerCounts[0][n], image.layers.before[n] = frame.layerCounts[1][n];
  holdRemote(frame, options, start);
  return snapshot.layers || !frame.seenThrough.load() ? Traced::whole : Traced::seenThrough;
}

}  // namespace

namespace {

/// Logs once that the setting `pixel-filter` has no effect.
void logUnusedFilter(const scene::Snapshot& snapshot, bool averages) {
  if (snapshot.settings.pixelFilter == PixelFilter::box) return;
  if (samplesPerPixel(snapshot.settings) <= 1)
    log::once(log::Level::warning, "pixel-filter",
              "pixel-filter has no effect: pixels have one sample each (spp = 1)");
  else if (!averages && !movesAliased(snapshot))
    log::once(log::Level::warning, "pixel-filter of samples",
              "pixel-filter has no effect on images whose samples are those of the framebuffer: multisampled "
              "ones, and translucent surfaces that are blended in the order of drawing");
}

}  // namespace

bool traceImage(const scene::Snapshot& snapshot, const accel::World& world, Arena& arena, Image& image,
                const TraceOptions& options) {
  const bool averages = options.averages && wantsAverages(snapshot);
  if (options.averages) logUnusedFilter(snapshot, averages);
  return arena.execute([&] {
    if (options.source) {
      shapeImage(snapshot, image, averages);
      if (world.empty()) {
        if (options.remote) options.remote->beginEmpty(snapshot);
        fillWithMisses(image);
        eachTileOf(*options.source, image, world.pages(), [](const Tile&) { return false; });
      } else {
        traceTiles(snapshot, world, image, options);
      }
      return true;
    }
    if (world.empty()) return clearImage(snapshot, image), true;
    if (averages) {
      shapeImage(snapshot, image, true);
      const Traced traced = traceTiles(snapshot, world, image, options);
      if (traced != Traced::seenThrough) return traced == Traced::whole;
      if (isComposed(snapshot))
        log::once(log::Level::info, "not composed",
                  "the program writes an alpha below 1 for opaque surfaces: GLuRay shows neither background "
                  "nor shadow catcher in its views");
    }
    shapeImage(snapshot, image, false);
    return traceTiles(snapshot, world, image, options) != Traced::interrupted;
  });
}

}  // namespace gluray::render
