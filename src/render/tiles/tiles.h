// The tiles of an image, and loops over them. Any thread.
#pragma once
#include "base/image.h"
#include "base/timeline.h"
#include "render/tiles/float_guard.h"
#include "render/tiles/tile.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <functional>

namespace gluray::render {

/// Whether tracing must stop; called before each tile, on all tracing threads.
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

/// Calls work(index) for the tiles that nextTile() returns, on all threads, until it returns a negative
/// number.
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

/// Calls work(tile) for all tiles, on all threads. Returns false if interrupted before the last tile.
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
