#include "cluster/worker/film/film_tiles.h"

#include <exception>

namespace gluray::cluster {

bool FilmTiles::complete(render::FactorFilm& film) noexcept {
  try {
    std::optional<FilmComes> comes = queue_.waitForFilm();
    if (!comes) return false;
    std::span<const std::byte> bytes = comes->film;
    Array array;
    if (bytes.empty()) {
      if (!store_.waitFor({comes->name}, [&] { return queue_.isClosed(); })) return false;
      array = store_.find(comes->name);
      bytes = array.bytes;
    }
    unpackFilm(bytes, wholeOf(shapeOf(film)), film);
    const render::Tiles all(film.width, film.height, render::kTileSize);
    std::erase_if(comes->tiles, [&](int32_t tile) { return tile < 0 || tile >= all.columns * all.rows; });
    tiles_ = std::move(comes->tiles);
    return true;
  } catch (const std::exception&) { return false; }  // the head traces the frame without the other ranks
}

int FilmTiles::nextToColor() noexcept {
  if (queue_.isClosed()) return -1;
  const size_t at = next_.fetch_add(1);
  return at < tiles_.size() ? tiles_[at] : -1;
}

}  // namespace gluray::cluster
