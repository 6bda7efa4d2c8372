// Tracks when a tile and all its neighbours are finished. Any thread.
#pragma once
#include "render/tiles/tiles.h"

#include <atomic>
#include <cstddef>
#include <vector>

namespace gluray::render {

/// Tells when all of a tile's neighbours are finished, so that its surroundings can be read while they are in
/// the caches.
class TilesAround {
 public:
  explicit TilesAround(const Image& image)
      : tiles_(image, kTileSize),
        unfinished_(static_cast<size_t>(tiles_.columns) * static_cast<size_t>(tiles_.rows)) {
    for (int y = 0; y < tiles_.rows; ++y)
      for (int x = 0; x < tiles_.columns; ++x) around(x, y, [&](int, int) { ++counterOf(x, y); });
  }
  /// Marks a tile as finished, and calls ready(tile) for each tile that waited only for this one. Any thread.
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

}  // namespace gluray::render
