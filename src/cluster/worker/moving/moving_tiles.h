// The tiles of a moving frame that this rank collects and then colours. Tracing threads.
#pragma once
#include "cluster/arrays/array_store.h"
#include "cluster/shares/tile_queue.h"
#include "render/moving/moving_tile_source.h"

#include <atomic>

namespace gluray::cluster {

class MovingTiles final : public render::MovingTileSource {
 public:
  /// Both must outlive it.
  MovingTiles(TileQueue& queue, ArrayStore& store, uint32_t index)
      : queue_(queue), store_(store), index_(index) {}

  void begin(const Image& image) noexcept override { queue_.begin(image); }
  int nextTile() noexcept override { return queue_.nextTile(); }
  void done(int tile, double seconds, bool seenThrough) noexcept override {
    queue_.done(tile, seconds, seenThrough);
  }
  uint32_t index(uint32_t) const noexcept override { return index_; }
  void collected(const render::VisibilityBuffer& buffer, int tile, double seconds) noexcept override {
    queue_.collected(buffer, tile, seconds);
  }
  bool complete(render::VisibilityBuffer& buffer) noexcept override;
  int nextToColor() noexcept override;

 private:
  TileQueue& queue_;
  ArrayStore& store_;
  const uint32_t index_;
  std::vector<int32_t> tiles_;
  std::atomic<size_t> next_{0};
};

}  // namespace gluray::cluster
