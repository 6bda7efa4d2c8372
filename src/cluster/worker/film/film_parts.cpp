#include "cluster/worker/film/film_parts.h"

#include <algorithm>

namespace gluray::cluster {

FilmParts::FilmParts(int width, int height)
    : tiles_(width, height, render::kTileSize),
      ranks_(static_cast<size_t>(tiles_.columns) * static_cast<size_t>(tiles_.rows), kNobody) {}

bool FilmParts::addTile(int rank, const FilmTile& tile) {
  check(tile.shape);
  if (tile.shape.width != tiles_.width || tile.shape.height != tiles_.height || tile.tile < 0 ||
      static_cast<size_t>(tile.tile) >= ranks_.size())
    throw Malformed("a tile of another film");
  if (film_.width == 0) film_.resize(tile.shape.width, tile.shape.height, tile.shape.factors);
  if (tile.shape != shapeOf(film_)) throw Malformed("a tile of another film");
  int& holder = ranks_[static_cast<size_t>(tile.tile)];
  if (holder != kNobody || given_) return false;
  unpackFilm(tile.film, tiles_.at(tile.tile), film_);
  holder = rank;
  ++awaited_;
  return true;
}

bool FilmParts::isAwaited(int rank, int tile) const {
  return tile >= 0 && static_cast<size_t>(tile) < ranks_.size() && ranks_[static_cast<size_t>(tile)] == rank;
}

bool FilmParts::isAwaited(int rank) const { return std::ranges::find(ranks_, rank) != ranks_.end(); }

void FilmParts::setColored(int tile) {
  int& holder = ranks_[static_cast<size_t>(tile)];
  if (holder != kNobody) --awaited_;
  holder = kNobody;
}

std::vector<int32_t> FilmParts::tilesOf(int rank) const {
  std::vector<int32_t> tiles;
  for (size_t tile = 0; tile < ranks_.size(); ++tile)
    if (ranks_[tile] == rank) tiles.push_back(static_cast<int32_t>(tile));
  return tiles;
}

Array FilmParts::give() {
  given_ = true;
  return makeArray(packFilm(film_, wholeOf(shapeOf(film_))));
}

}  // namespace gluray::cluster
