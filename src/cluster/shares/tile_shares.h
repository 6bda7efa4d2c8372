// Distributes the tiles of an image over ranks: shares of equal cost, as measured in the previous frame,
// with work stealing by ranks that finish first.
#pragma once
#include <cstddef>
#include <vector>

namespace gluray::cluster {

/// A rank that may trace.
struct Tracer {
  int threads = 1;
  float speed = 1;  // relative speed of a thread, in tile cost per time
  bool here = true;
};

/// The tiles of one image. A rank's share is one run of neighbouring tiles. It gets a part of its share at
/// once, and more when it has traced most of that. A rank that has used up its share steals from the end of
/// the largest remainder. One thread.
class TileShares {
 public:
  /// `costs`: of each tile, any unit, > 0. Tiles with `wanted` 0 are not traced; null: all are.
  TileShares(const std::vector<float>& costs, const std::vector<unsigned char>* wanted,
             const std::vector<Tracer>& tracers);

  /// Returns more tiles for the rank; none if it has enough, or nothing is left.
  std::vector<int> more(int rank);
  /// A rank has traced the tile. Returns false if the tile was already traced, or does not exist.
  bool finish(int tile);
  /// The rank is gone: reassigns its untraced tiles.
  void drop(int rank);
  /// The rank is slow: reassigns its untraced tiles, and assigns it none until resume(). Tiles that it still
  /// traces count.
  void giveBack(int rank);
  void resume(int rank) { ranks_[static_cast<size_t>(rank)].paused = false; }
  /// Whether the rank could trace more than it has.
  bool isIdle(int rank) const;
  /// Whether all tiles have been traced.
  bool done() const { return left_ == 0; }
  /// Number of assigned, untraced tiles of the rank.
  size_t pending(int rank) const { return ranks_[static_cast<size_t>(rank)].pending; }

 private:
  struct Rank {
    Tracer tracer;
    std::vector<int> rest;  // of its share, in order: what no rank has got
    size_t pending = 0;
    bool paused = false;
    bool takes() const { return tracer.here && !paused; }
  };
  static constexpr int kNotWanted = -3, kTraced = -2, kNobody = -1;  // of holder_; else the tile's rank
  float costOf(const std::vector<int>& tiles) const;
  void takeFromOthers(Rank& rank);
  void hand(std::vector<int> tiles, int notTo);

  const std::vector<float> costs_;
  std::vector<Rank> ranks_;
  std::vector<int> holder_;  // by tile
  size_t left_ = 0;
};

}  // namespace gluray::cluster
