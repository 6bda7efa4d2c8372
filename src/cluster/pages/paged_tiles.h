// Hands out the tiles of an image with paged geometry, until a page cannot be fetched. All tracing threads.
#pragma once
#include "cluster/pages/page_store.h"
#include "render/tiles/tile_source.h"
#include "render/tiles/tiles.h"

namespace gluray::cluster {

class PagedTiles final : public render::TileSource {
 public:
  /// Both must outlive it.
  PagedTiles(render::TileSource& tiles, const PageStore& pages) : tiles_(tiles), pages_(pages) {}
  void begin(const Image& image) noexcept override { tiles_.begin(image); }
  int nextTile() noexcept override { return pages_.hasFailed() ? -1 : tiles_.nextTile(); }
  void done(int tile, double seconds, bool seenThrough) noexcept override {
    if (!pages_.hasFailed()) tiles_.done(tile, seconds, seenThrough);
  }

 private:
  render::TileSource& tiles_;
  const PageStore& pages_;
};

}  // namespace gluray::cluster
