// The tiles of a picture whose queries go to peers: which are still to be traced, wait for answers, or have
// theirs. Guarded by its owner, except that one thread uses the record of a tile it traces.
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
  /// Forgets all. `peers`: that may be asked.
  void reset(std::vector<int> tiles, size_t peers);
  struct Work {
    int tile = -1;  // none
    TileRecord* record = nullptr;
  };
  /// The next tile to trace: rather one with answers than a new one.
  Work takeWork();
  /// Its pixels are final.
  void finish(int tile);
  /// It waits for so many answers.
  void wait(int tile, size_t answers) { at_.at(tile).missing = answers; }
  /// An answer of a peer. True: it was the tile's last one that was missing. Throws Malformed.
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
