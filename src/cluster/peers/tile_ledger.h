// State of the tiles of an image with queries to peers: untraced, waiting for the depths of peers, seen,
// waiting for answers, or answered. Guarded by its owner, except that the thread that traces a tile uses the
// tile's record.
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
  /// Resets all tiles. `shared`: peers have depths there, and await this rank's. `alone`: the others.
  /// `peers`: number of peers.
  void reset(std::vector<int> shared, std::vector<int> alone, size_t peers);
  struct Work {
    int tile = -1;  // none
    TileRecord* record = nullptr;
  };
  /// Returns the next tile to trace: first those with answers, then those whose depths peers await, then
  /// those that have the depths of peers, then all others.
  Work takeWork();
  /// Lets the tile wait for the depths of these peers, of which there is at least one.
  void park(int tile, std::vector<size_t> awaited) { at_.at(tile).awaited = std::move(awaited); }
  /// Returns true if the tile has waited for these depths.
  bool depthsCame(int tile, size_t peer);
  /// No more depths come from this peer. Returns how many tiles have waited for them.
  size_t depthsEnd(size_t peer);
  /// Marks the tile's pixels as final.
  void finish(int tile);
  /// Marks the tile as waiting for so many answers.
  void wait(int tile, size_t answers) { at_.at(tile).missing = answers; }
  /// Records a peer's answer. Returns true if it was the tile's last missing answer. Throws Malformed.
  bool answer(int tile, int peer, std::span<const std::byte> answers);
  bool isDone() const { return left_ == 0; }
  /// Whether a tile waits for depths of peers.
  bool awaitsDepths() const;
  /// Whether there are untraced tiles whose depths peers await.
  bool hasShared() const { return !shared_.empty(); }

 private:
  struct Open {
    std::unique_ptr<TileRecord> record;
    size_t missing = 0;           // answers
    std::vector<size_t> awaited;  // peers whose depths are missing
  };
  std::deque<int> shared_, alone_;  // untraced
  std::deque<int> seen_, ready_;    // with all depths, or all answers, that they have waited for
  std::unordered_map<int, Open> at_;
  size_t left_ = 0, peers_ = 0;
};

}  // namespace gluray::cluster
