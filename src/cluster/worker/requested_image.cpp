#include "cluster/worker/requested_image.h"

#include "render/tiles/tiles.h"

#include <algorithm>
#include <utility>

namespace gluray::cluster {
namespace {

constexpr double kSlow = 0.5;       // seconds without a tile
constexpr double kSlowInPages = 5;  // the same where ranks fetch the geometry that a tile needs

render::Tiles tilesOf(int width, int height) { return {width, height, render::kTileSize}; }

std::vector<float> knownCosts(const std::vector<float>& costs, size_t tiles) {
  return costs.size() == tiles ? costs : std::vector<float>(tiles, 1e-3f);
}

std::vector<bool> hereOf(const std::vector<Tracer>& tracers) {
  std::vector<bool> here;
  for (const Tracer& tracer : tracers) here.push_back(tracer.here);
  return here;
}

}  // namespace

size_t RequestedImage::tilesOf(const TraceRequest& request) {
  const render::Tiles tiles = cluster::tilesOf(request.width, request.height);
  return static_cast<size_t>(tiles.columns) * static_cast<size_t>(tiles.rows);
}

RequestedImage::RequestedImage(const TraceRequest& request, uint64_t id, bool averages,
                               const RankStates& ranks, const std::vector<float>& costs, Kind kind,
                               double now)
    : id_(id),
      programId_(request.id),
      kind_(kind),
      averages_(averages),
      layered_(request.layered),
      slowAfter_(kind == Kind::paged ? kSlowInPages : kSlow),
      width_(request.width),
      height_(request.height),
      start_(now),
      self_(ranks.self()),
      costs_(knownCosts(costs, tilesOf(request))),
      shares_(costs_, request.wanted.empty() ? nullptr : &request.wanted, ranks.tracers(kind == Kind::alone)),
      asked_(hereOf(ranks.tracers(kind == Kind::alone))),
      here_(asked_),
      ended_(here_.size()),
      lastResult_(here_.size(), now) {
  if (kind == Kind::moving) visibility_.emplace(width_, height_);
}

void RequestedImage::addTile(int rank, const TracedTile& tile, WrittenMemory& memory, bool& grew,
                             double now) {
  grew = false;
  if (!shape_) {
    if (tile.shape.width != width_ || tile.shape.height != height_)
      throw Malformed("a tile of another image");
    if (bytesOf(tile.shape) > memory.bytes) memory = writtenMemory(bytesOf(tile.shape)), grew = true;
    shape_ = tile.shape;
  }
  if (tile.shape != *shape_) throw Malformed("a tile of another image");
  lastResult_[static_cast<size_t>(rank)] = now;
  shares_.resume(rank);
  const bool isColored = visibility_ && visibility_->isAwaited(rank, tile.tile);
  if (!isColored && !shares_.finish(tile.tile)) return;
  unpackTile(tile.pixels, *shape_, planesIn(memory.at.get(), *shape_),
             cluster::tilesOf(width_, height_).at(tile.tile));
  if (isColored) visibility_->setColored(tile.tile);
  float& cost = costs_[static_cast<size_t>(tile.tile)];
  cost = std::max(tile.seconds + (isColored ? cost : 0), 1e-6f);
  seenThrough_ = seenThrough_ || tile.seenThrough;
}

void RequestedImage::addTile(int rank, const CollectedTile& tile, double now) {
  if (!visibility_) throw Malformed("the image has no visibility buffer");
  lastResult_[static_cast<size_t>(rank)] = now;
  shares_.resume(rank);
  if (!visibility_->addTile(rank, tile)) return;
  shares_.finish(tile.tile);
  costs_[static_cast<size_t>(tile.tile)] = std::max(tile.seconds, 1e-6f);
}

Array RequestedImage::giveVisibility(double now) {
  lastResult_.assign(lastResult_.size(), now);
  return visibility_->give();
}

void RequestedImage::finished(int rank, const Finished& result) {
  ended_[static_cast<size_t>(rank)] = true;
  if (!result.error.empty()) {
    drop(rank);
    if (rank == self_ || std::ranges::none_of(here_, [](bool here) { return here; }))
      error_ = result.error, result_.cost.loss = result.cost.loss;
    return;
  }
  for (size_t n = 0; n < LayerCounts::kMax; ++n)
    result_.layers.open[n] += result.layers.open[n], result_.layers.before[n] += result.layers.before[n];
  if (rank == self_) result_.cost = result.cost, result_.improves = result.improves;
}

void RequestedImage::drop(int rank) {
  shares_.drop(rank);
  here_[static_cast<size_t>(rank)] = false;
  lost_ = lost_ || (visibility_ && visibility_->isAwaited(rank));
  // Its numbers of layers are lost.
  if (layered_) error_ = "a rank of the job is gone";
}

/// Of a moving image whose tiles are being coloured: others cannot take them over.
std::vector<int> RequestedImage::dropSlow(double now) {
  std::vector<int> slow;
  for (int rank = 0; rank < static_cast<int>(here_.size()); ++rank)
    if (rank != self_ && takesPart(rank) && visibility_->isAwaited(rank) &&
        now - lastResult_[static_cast<size_t>(rank)] > slowAfter_)
      slow.push_back(rank);
  for (const int rank : slow) drop(rank);
  return slow;
}

std::vector<int> RequestedImage::passOnSlow(double now) {
  if (hasVisibility()) return dropSlow(now);
  bool idle = false;
  for (size_t rank = 0; rank < here_.size(); ++rank) idle = idle || shares_.isIdle(static_cast<int>(rank));
  // Numbers of layers are those of all that ranks have traced: nothing may be traced twice.
  if (!idle || layered_ || shares_.done()) return {};
  std::vector<int> slow;
  for (size_t rank = 0; rank < here_.size(); ++rank)
    if (here_[rank] && shares_.pending(static_cast<int>(rank)) > 0 && now - lastResult_[rank] > slowAfter_) {
      shares_.giveBack(static_cast<int>(rank));
      lastResult_[rank] = now;
      slow.push_back(static_cast<int>(rank));
    }
  return slow;
}

bool RequestedImage::isDone() const {
  if (!isTraced()) return false;
  for (size_t rank = 0; rank < here_.size(); ++rank)
    if (here_[rank] && !ended_[rank] && (layered_ || static_cast<int>(rank) == self_)) return false;
  return true;
}

ImageDone RequestedImage::result(double now) const {
  ImageDone done = result_;
  done.id = programId_;
  done.whole = error_.empty() && shape_.has_value();
  done.error = error_.empty() && !shape_ ? "nothing was traced" : error_;
  if (shape_) done.shape = *shape_;
  done.cost.traceSeconds = std::max(now - start_ - done.cost.buildSeconds, 0.0);
  return done;
}

}  // namespace gluray::cluster
