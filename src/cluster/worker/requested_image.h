// A requested image at the head: distributes its tiles over ranks, and collects their pixels. The worker's
// main thread.
#pragma once
#include "cluster/local/sealed_memory.h"
#include "cluster/messages/program_messages.h"
#include "cluster/messages/rank_messages.h"
#include "cluster/shares/tile_shares.h"
#include "cluster/worker/moving/gathered_visibility.h"
#include "cluster/worker/rank_states.h"

#include <optional>
#include <string>
#include <vector>

namespace gluray::cluster {

class RequestedImage {
 public:
  /// How its tiles are traced.
  enum class Kind {
    alone,  // all on this rank
    shared,
    paged,   // the geometry is in pages
    moving,  // first collected on the visibility buffer, then coloured by the same rank
  };
  /// `costs`: of the tiles, as measured before; other numbers of tiles count as unknown.
  RequestedImage(const TraceRequest& request, uint64_t id, bool averages, const RankStates& ranks,
                 const std::vector<float>& costs, Kind kind, double now);

  uint64_t id() const { return id_; }
  Kind kind() const { return kind_; }
  bool averages() const { return averages_; }
  bool takesPart(int rank) const { return here_[static_cast<size_t>(rank)]; }
  /// Whether the rank was involved at the start.
  bool asks(int rank) const { return asked_[static_cast<size_t>(rank)]; }

  /// Tiles that the rank gets now.
  std::vector<int> more(int rank) { return shares_.more(rank); }
  size_t pending(int rank) const { return shares_.pending(rank); }
  /// Writes the tile into `memory`, which it enlarges if necessary (`grew`). Throws Malformed if the tile
  /// does not fit the image; std::system_error.
  void addTile(int rank, const TracedTile& tile, WrittenMemory& memory, bool& grew, double now);
  /// Adds a tile to a moving image's visibility buffer.
  void addTile(int rank, const CollectedTile& tile, double now);
  void finished(int rank, const Finished& result);
  void drop(int rank);
  /// Whether hits of a moving image are lost, so that it must be traced again.
  bool isLost() const { return lost_; }
  /// Whether all tiles of a moving image have been collected and the ranks do not have the visibility yet.
  bool isCollected() const {
    return visibility_ && shares_.done() && !visibility_->isColored() && !visibility_->isGiven();
  }
  /// The visibility buffer, for the ranks.
  Array giveVisibility(double now);
  bool hasVisibility() const { return visibility_ && visibility_->isGiven(); }
  std::vector<int32_t> toColor(int rank) const { return visibility_->tilesOf(rank); }
  /// Reassigns the tiles of slow ranks once no other tiles are left. Returns these ranks.
  std::vector<int> passOnSlow(double now);

  /// Whether averages cannot be composited, so that the image must be traced again without them.
  bool isSeenThrough() const { return seenThrough_; }
  bool isTraced() const { return shares_.done() && (!visibility_ || visibility_->isColored()); }
  /// Whether all tiles have arrived.
  bool isDone() const;
  /// Reason of a failure; empty: none.
  const std::string& error() const { return error_; }
  /// Result for the program.
  ImageDone result(double now) const;
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
  const int self_;  // whose figures stand for the image's
  std::vector<float> costs_;
  TileShares shares_;
  std::optional<GatheredVisibility> visibility_;  // of moving images
  bool lost_ = false;
  const std::vector<bool> asked_;
  std::vector<bool> here_, ended_;
  std::vector<double> lastResult_;
  std::optional<ImageShape> shape_;
  bool seenThrough_ = false;
  std::string error_;
  ImageDone result_;
};

}  // namespace gluray::cluster
