// The tiles of an image, and loops over them. Any thread.
#pragma once
#include "base/image.h"
#include "base/timeline.h"
#include "render/float_guard.h"
#include "render/frame_data.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <functional>

namespace gluray::render {

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
