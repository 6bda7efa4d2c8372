// Which rank traces which tiles of a picture: shares of equal cost, as measured in the frame before, and what
// is left of them to those that are done first.
#pragma once
#include <cstddef>
#include <vector>

namespace gluray::cluster {

/// A rank that may take part.
struct Tracer {
  int threads = 1;
  float speed = 1;  // tiles' cost that a thread traces in a unit of time, relative to the others
  bool here = true;
};

/// The tiles of one picture. A rank's share is one run of neighbouring tiles. It gets a part of it at once
/// and more when it has traced most of that; a rank whose share is used up takes from the end of the largest
/// rest. One thread.
class TileShares {
 public:
  /// `costs`: of each tile, any unit, > 0. Tiles with `wanted` 0 are not traced; null: all are.
  TileShares(const std::vector<float>& costs, const std::vector<unsigned char>* wanted,
             const std::vector<Tracer>& tracers);

  /// Tiles that the rank gets now; none: it has enough, or nothing is left.
  std::vector<int> more(int rank);
  /// A rank has traced the tile. False: it had been traced already, or it is none.
  bool finish(int tile);
  /// The rank is gone: others get what it has not traced.
  void drop(int rank);
  /// The rank is slow: others get what it has not traced, and it gets nothing until resume(). What it traces
  /// all the same counts.
  void giveBack(int rank);
  void resume(int rank) { ranks_[static_cast<size_t>(rank)].paused = false; }
  /// Whether the rank could trace more than it has.
  bool isIdle(int rank) const;
  /// Whether all tiles have been traced.
  bool done() const { return left_ == 0; }
  /// Tiles that the rank has got and not traced.
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
