// State of the tiles of an image with queries to peers: untraced, waiting for answers, or answered. Guarded
// by its owner, except that the thread that traces a tile uses the tile's record.
#pragma once
#include "cluster/peers/tile_record.h"

#include <cstddef>
#include <deque>
#include <memory>
#include <unordered_map>
#include <vector>

namespace gluray::cluster {

class TileLedger {
 public:
  /// Resets all tiles. `peers`: number of peers for queries.
  void reset(std::vector<int> tiles, size_t peers);
  struct Work {
    int tile = -1;  // none
    TileRecord* record = nullptr;
  };
  /// Returns the next tile to trace; tiles with answers come before new ones.
  Work takeWork();
  /// Marks the tile's pixels as final.
  void finish(int tile);
  /// Marks the tile as waiting for so many answers.
  void wait(int tile, size_t answers) { at_.at(tile).missing = answers; }
  /// Records a peer's answer. Returns true if it was the tile's last missing answer. Throws Malformed.
  bool answer(int tile, int peer, std::span<const std::byte> answers);
  bool isDone() const { return left_ == 0; }

 private:
  struct Open {
    std::unique_ptr<TileRecord> record;
    size_t missing = 0;
  };
  std::deque<int> fresh_, ready_;
  std::unordered_map<int, Open> at_;
  size_t left_ = 0, peers_ = 0;
};

}  // namespace gluray::cluster
