// The tiles of an image, and loops over them. Any thread.
#pragma once
#include "base/image.h"
#include "base/timeline.h"
#include "render/float_guard.h"
#include "render/frame_data.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <functional>

namespace gluray::render {

struct FactorFilm;

/// Whether tracing must stop; asked before each tile, on all tracing threads.
using Interrupt = std::function<bool()>;

/// The tiles of an image, row by row, kTileSize pixels wide and at most as high.
struct Tiles {
  int width, height, tileHeight, columns, rows;
  Tiles(const Image& image, int heightOfTiles) : Tiles(image.width, image.height, heightOfTiles) {}
  Tiles(int imageWidth, int imageHeight, int heightOfTiles)
      : width(imageWidth),
        height(imageHeight),
        tileHeight(heightOfTiles),
        columns((width + kTileSize - 1) / kTileSize),
        rows((height + tileHeight - 1) / tileHeight) {}
  Tile at(int index) const {
    const int x = index % columns * kTileSize, y = index / columns * tileHeight;
    return {x, y, std::min(x + kTileSize, width), std::min(y + tileHeight, height)};
  }
};

/// Hands out the tiles of an image that several processes trace together. All tracing threads.
class TileSource {
 public:
  virtual ~TileSource() = default;
  /// Called once, before all else: the image has its shape and keeps its place; its pixels are undefined.
  virtual void begin(const Image& image) noexcept = 0;
  /// The next tile to trace, an index of Tiles; negative: there are no more. May wait.
  virtual int next() noexcept = 0;
  /// The tile's pixels are in the image. `seenThrough`: averages cannot be composited over the framebuffer,
  /// as far as this process has seen: the image must be traced anew without them.
  virtual void done(int tile, double seconds, bool seenThrough) noexcept = 0;
};

/// Hands out the tiles of a moving frame (scene::LightSampling::Mode::moving) that several processes trace
/// together. Each tile is collected first: its hits, and its surfaces and factors on the film. Once the film
/// is whole, the process that collected a tile colours it. Frames that cannot be traced like that take the
/// functions of a TileSource alone.
class FilmSource : public TileSource {
 public:
  /// The frame's number among those of its view; `own`: as this process counts them. Processes that share one
  /// film have the same number.
  virtual uint32_t index(uint32_t own) const noexcept = 0;
  /// The tile, from next(), has been collected. All tracing threads.
  virtual void collected(const FactorFilm& film, int tile, double seconds) noexcept = 0;
  /// Waits until all tiles have been collected, and fills in what other processes have. False: the frame is
  /// given up. One thread, once next() has no more tiles.
  virtual bool complete(FactorFilm& film) noexcept = 0;
  /// The next tile to colour, one that this process has collected; negative: there are no more. done() is
  /// called afterwards. All tracing threads.
  virtual int nextToColor() noexcept = 0;
};

/// Calls work(index) for the tiles that next() gives, on all threads, until it gives a negative number.
template <class Next, class Work>
void eachTileFrom(const char* name, const Next& next, const Work& work) {
  tbb::parallel_for(
      0, tbb::this_task_arena::max_concurrency(),
      [&](int) {
        const FloatGuard guard;
        timeline::nameThread("tracing");
        for (int index = next(); index >= 0; index = next()) {
          const timeline::Span span(name, 1, true);
          work(index);
        }
      },
      tbb::simple_partitioner());
}

/// Calls work(tile) for all tiles, on all threads. False: interrupted before the last one.
template <class Work>
bool eachTile(const Tiles& tiles, const char* name, const Interrupt& interrupt, const Work& work) {
  std::atomic<bool> interrupted{false};
  tbb::parallel_for(0, tiles.columns * tiles.rows, [&](int index) {
    if (interrupt && interrupt()) return interrupted.store(true, std::memory_order_relaxed);
    const FloatGuard guard;
    timeline::nameThread("tracing");
    const timeline::Span span(name, 1, true);
    work(tiles.at(index));
  });
  return !interrupted;
}

}  // namespace gluray::render
