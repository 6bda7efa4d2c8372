// The visibility buffer of a moving frame at its head: assembles the tiles that ranks collect, and tracks
// which rank colours which tile. The worker's main thread.
#pragma once
#include "cluster/messages/rank_messages.h"
#include "cluster/stream/shared_arrays.h"
#include "render/tiles/tiles.h"

#include <vector>

namespace gluray::cluster {

class GatheredVisibility {
 public:
  GatheredVisibility(int width, int height);

  /// Adds a tile that `rank` has collected to the visibility buffer. Returns false for a duplicate. Throws
  /// Malformed.
  bool addTile(int rank, const CollectedTile& tile);
  /// Whether the rank has collected the tile and not coloured it.
  bool isAwaited(int rank, int tile) const;
  bool isAwaited(int rank) const;
  void setColored(int tile);
  /// Whether all collected tiles are coloured.
  bool isColored() const { return awaited_ == 0; }
  /// The tiles that the rank is to colour.
  std::vector<int32_t> tilesOf(int rank) const;

  /// Returns the visibility buffer to send to the ranks.
  Array give();
  bool isGiven() const { return given_; }

 private:
  static constexpr int kNobody = -1;  // of ranks_: not collected, or coloured

  render::Tiles tiles_;
  render::VisibilityBuffer visibility_;  // no pixels before the first tile
  std::vector<int> ranks_;               // by tile
  size_t awaited_ = 0;
  bool given_ = false;
};

}  // namespace gluray::cluster
