#include "cluster/shares/tile_queue.h"

#include <new>
#include <utility>

namespace gluray::cluster {

void TileQueue::add(const std::vector<int32_t>& tiles) {
  {
    const std::lock_guard lock(mutex_);
    tiles_.insert(tiles_.end(), tiles.begin(), tiles.end());
  }
  more_.notify_all();
}

void TileQueue::close() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  more_.notify_all();
}

void TileQueue::setVisibility(VisibilityReady comes) {
  {
    const std::lock_guard lock(mutex_);
    visibility_ = std::move(comes);
  }
  more_.notify_all();
}

std::optional<VisibilityReady> TileQueue::waitForVisibility() {
  std::unique_lock lock(mutex_);
  more_.wait(lock, [&] { return closed_ || visibility_; });
  if (closed_) return std::nullopt;
  return visibility_;
}

void TileQueue::collected(const render::VisibilityBuffer& buffer, int tile, double seconds) noexcept {
  try {
    CollectedTile collected{id_, shapeOf(buffer), tile, static_cast<float>(seconds), {}};
    collected.visibility = packVisibility(buffer, render::Tiles(*image_, render::kTileSize).at(tile));
    outbox_.push(head_, forRanks(collected));
  } catch (const std::bad_alloc&) {}  // the head gives the tile to another rank
}

int TileQueue::nextTile() noexcept {
  std::unique_lock lock(mutex_);
  const int count = image_ ? render::Tiles(*image_, render::kTileSize).columns *
                                 render::Tiles(*image_, render::kTileSize).rows
                           : 0;
  for (;;) {
    more_.wait(lock, [&] { return closed_ || visibility_ || !tiles_.empty(); });
    if (closed_ || visibility_) return -1;
    const int tile = tiles_.front();
    tiles_.pop_front();
    if (tile >= 0 && tile < count) return tile;  // the head may be mistaken
  }
}

void TileQueue::done(int tile, double seconds, bool seenThrough) noexcept {
  try {
    TracedTile traced{id_, shapeOf(*image_), tile, static_cast<float>(seconds), seenThrough, {}};
    traced.pixels = packTile(*image_, render::Tiles(*image_, render::kTileSize).at(tile));
    outbox_.push(head_, forRanks(traced));
  } catch (const std::bad_alloc&) {}  // the head gives the tile to another rank
}

void TileQueue::doneAll(const Image& image, double seconds) {
  begin(image);
  const render::Tiles tiles(image, render::kTileSize);
  const int count = tiles.columns * tiles.rows;
  for (int tile = 0; tile < count; ++tile) done(tile, seconds / count, false);
}

}  // namespace gluray::cluster
