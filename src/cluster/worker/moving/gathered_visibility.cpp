#include "cluster/worker/moving/gathered_visibility.h"

#include <algorithm>

namespace gluray::cluster {

GatheredVisibility::GatheredVisibility(int width, int height)
    : tiles_(width, height, render::kTileSize),
      ranks_(static_cast<size_t>(tiles_.columns) * static_cast<size_t>(tiles_.rows), kNobody) {}

bool GatheredVisibility::addTile(int rank, const CollectedTile& tile) {
  check(tile.shape);
  if (tile.shape.width != tiles_.width || tile.shape.height != tiles_.height || tile.tile < 0 ||
      static_cast<size_t>(tile.tile) >= ranks_.size())
    throw Malformed("a tile of another moving frame");
  if (visibility_.width == 0) visibility_.resize(tile.shape.width, tile.shape.height, tile.shape.channels);
  if (tile.shape != shapeOf(visibility_)) throw Malformed("a tile of another moving frame");
  int& holder = ranks_[static_cast<size_t>(tile.tile)];
  if (holder != kNobody || given_) return false;
  unpackVisibility(tile.visibility, tiles_.at(tile.tile), visibility_);
  holder = rank;
  ++awaited_;
  return true;
}

bool GatheredVisibility::isAwaited(int rank, int tile) const {
  return tile >= 0 && static_cast<size_t>(tile) < ranks_.size() && ranks_[static_cast<size_t>(tile)] == rank;
}

bool GatheredVisibility::isAwaited(int rank) const { return std::ranges::find(ranks_, rank) != ranks_.end(); }

void GatheredVisibility::setColored(int tile) {
  int& holder = ranks_[static_cast<size_t>(tile)];
  if (holder != kNobody) --awaited_;
  holder = kNobody;
}

std::vector<int32_t> GatheredVisibility::tilesOf(int rank) const {
  std::vector<int32_t> tiles;
  for (size_t tile = 0; tile < ranks_.size(); ++tile)
    if (ranks_[tile] == rank) tiles.push_back(static_cast<int32_t>(tile));
  return tiles;
}

Array GatheredVisibility::give() {
  given_ = true;
  return makeArray(packVisibility(visibility_, wholeOf(shapeOf(visibility_))));
}

}  // namespace gluray::cluster
