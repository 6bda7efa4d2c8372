// A picture that a program asked for, at the head: who traces which of its tiles, and the pixels that come
// back. The worker's main thread.
#pragma once
#include "cluster/local/sealed_memory.h"
#include "cluster/messages/program_messages.h"
#include "cluster/messages/rank_messages.h"
#include "cluster/shares/tile_shares.h"
#include "cluster/worker/film/film_parts.h"
#include "cluster/worker/rank_states.h"

#include <optional>
#include <string>
#include <vector>

namespace gluray::cluster {

class Picture {
 public:
  /// How its tiles come.
  enum class Kind {
    alone,  // all from this rank
    shared,
    paged,   // the geometry is in pages
    moving,  // first onto the film, then with their colours, from the same rank
  };
  /// `costs`: of the tiles, as measured before; other numbers of tiles count as unknown.
  Picture(const TraceRequest& request, uint64_t id, bool averages, const RankStates& ranks,
          const std::vector<float>& costs, Kind kind, double now);

  uint64_t id() const { return id_; }
  Kind kind() const { return kind_; }
  bool averages() const { return averages_; }
  bool takesPart(int rank) const { return here_[static_cast<size_t>(rank)]; }
  /// Whether the rank took part in the beginning.
  bool asks(int rank) const { return asked_[static_cast<size_t>(rank)]; }

  /// Tiles that the rank gets now.
  std::vector<int> more(int rank) { return shares_.more(rank); }
  size_t pending(int rank) const { return shares_.pending(rank); }
  /// Puts the tile into `memory`, which it makes large enough (`grew`). Throws Malformed where the tile does
  /// not fit the picture; std::system_error.
  void addTile(int rank, const TracedTile& tile, WrittenMemory& memory, bool& grew, double now);
  /// The same of a moving picture's film.
  void addTile(int rank, const FilmTile& tile, double now);
  void finished(int rank, const Finished& result);
  void drop(int rank);
  /// Hits of a moving picture are lost: it must be traced anew.
  bool isLost() const { return lost_; }
  /// Whether all tiles of a moving picture have been collected and the ranks do not have the film yet.
  bool isCollected() const { return film_ && shares_.done() && !film_->isColored() && !film_->isGiven(); }
  /// The film, for the ranks.
  Array giveFilm(double now);
  bool hasFilm() const { return film_ && film_->isGiven(); }
  std::vector<int32_t> toColor(int rank) const { return film_->tilesOf(rank); }
  /// Others take over what ranks have had for long without a result, once nothing else is left. Returns these
  /// ranks.
  std::vector<int> passOnSlow(double now);

  /// Averages cannot be composited: the picture must be traced anew without them.
  bool isSeenThrough() const { return seenThrough_; }
  bool isTraced() const { return shares_.done() && (!film_ || film_->isColored()); }
  /// Whether all that the program gets has come.
  bool isDone() const;
  /// Why it cannot be done; empty: it can.
  const std::string& error() const { return error_; }
  /// What the program gets.
  PictureDone result(double now) const;
  /// Seconds by tile, as measured now or before.
  const std::vector<float>& costs() const { return costs_; }

 private:
  static size_t tilesOf(const TraceRequest& request);
  std::vector<int> dropSlow(double now);

  const uint64_t id_, programId_;
  const Kind kind_;
  const bool averages_, layered_;
  const double slowAfter_;  // seconds
  const int width_, height_;
  const double start_;
  const int self_;  // whose figures stand for the picture's
  std::vector<float> costs_;
  TileShares shares_;
  std::optional<FilmParts> film_;  // of moving pictures
  bool lost_ = false;
  const std::vector<bool> asked_;
  std::vector<bool> here_, ended_;
  std::vector<double> lastResult_;
  std::optional<ImageShape> shape_;
  bool seenThrough_ = false;
  std::string error_;
  PictureDone result_;
};

}  // namespace gluray::cluster
