// The tiles of a moving frame that this rank collects and then colours. Tracing threads.
#pragma once
#include "cluster/arrays/array_store.h"
#include "cluster/shares/tile_queue.h"
#include "render/moving/film_source.h"

#include <atomic>

namespace gluray::cluster {

class FilmTiles final : public render::FilmSource {
 public:
  /// Both must outlive it.
  FilmTiles(TileQueue& queue, ArrayStore& store, uint32_t index)
      : queue_(queue), store_(store), index_(index) {}

  void begin(const Image& image) noexcept override { queue_.begin(image); }
  int nextTile() noexcept override { return queue_.nextTile(); }
  void done(int tile, double seconds, bool seenThrough) noexcept override {
    queue_.done(tile, seconds, seenThrough);
  }
  uint32_t index(uint32_t) const noexcept override { return index_; }
  void collected(const render::FactorFilm& film, int tile, double seconds) noexcept override {
    queue_.collected(film, tile, seconds);
  }
  bool complete(render::FactorFilm& film) noexcept override;
  int nextToColor() noexcept override;

 private:
  TileQueue& queue_;
  ArrayStore& store_;
  const uint32_t index_;
  std::vector<int32_t> tiles_;
  std::atomic<size_t> next_{0};
};

}  // namespace gluray::cluster
