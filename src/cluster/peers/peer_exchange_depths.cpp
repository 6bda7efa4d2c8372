// PeerExchange: depths before light. Tracing threads, but for receive().
#include "base/clock.h"
#include "cluster/peers/peer_exchange.h"
#include "cluster/peers/tile_depths.h"
#include "render/frame_data/frame_data.h"
#include "render/tiles/tiles.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace gluray::cluster {
namespace {

constexpr size_t kBatch = 8;  // tiles of a message

}  // namespace

void PeerExchange::receive(TileDepths depths, double now) {
  const std::lock_guard lock(mutex_);
  const int rank = depths.address.from;
  heard_[static_cast<size_t>(rank)] = now;
  const size_t near = nearOf(rank);
  bool waited = false;
  for (size_t i = 0; i < std::min(depths.tiles.size(), depths.packed.size()); ++i) {
    depths_.receive(rank, depths.round, depths.tiles[i], std::move(depths.packed[i]));
    if (near == near_.size() || !ledger_.depthsCame(depths.tiles[i], near)) continue;
    --waiting_[near], waited = true;
  }
  if (waited) changed_.notify_all();
}

void PeerExchange::receive(const NoDepths& none, double now) {
  const std::lock_guard lock(mutex_);
  heard_[static_cast<size_t>(none.address.from)] = now;
  depths_.withhold(none.address.from, none.round);
  endDepths(none.address.from);
  changed_.notify_all();
}

void PeerExchange::endDepths(int rank) {
  const size_t near = nearOf(rank);
  if (near < near_.size()) waiting_[near] -= ledger_.depthsEnd(near);
}

bool PeerExchange::sharesTile(size_t near, int column, int row) const {
  return own_.contains(column, row) && near_[near].drawn().contains(column, row);
}

void PeerExchange::orderTiles(const render::Tiles& all) {
  std::vector<int> shared, alone;
  for (const int tile : tiles_) {
    bool meets = false;
    for (size_t i = 0; i < near_.size() && !meets; ++i)
      meets = mayHide(i, tile % all.columns, tile / all.columns) ||
              mayBeHidden(i, tile % all.columns, tile / all.columns);
    (meets ? shared : alone).push_back(tile);
  }
  columns_ = all.columns;
  ledger_.reset(std::move(shared), std::move(alone), near_.size());
}

bool PeerExchange::hasDepths() const noexcept { return record() && record()->isSeen(); }

bool PeerExchange::exchangeDepths(const render::Tile& tile, const Image& image) noexcept {
  TileRecord* const seen = record();
  if (!seen) return false;
  spent(PeerTimes::eye);
  began() = nowSeconds();  // of the light, unless the tile waits
  const int number = tileOf(tile), column = number % columns_, row = number / columns_;
  seen->see();
  try {
    sendDepths(number, tile, image);
    const std::lock_guard lock(mutex_);
    std::vector<size_t> awaited;
    for (size_t i = 0; i < near_.size(); ++i) {
      const int rank = near_[i].rank();
      if (mayBeHidden(i, column, row) && !depths_.find(rank, number) && asking_[static_cast<size_t>(rank)] &&
          !depths_.withholds(rank))
        awaited.push_back(i);
    }
    if (awaited.empty()) return false;
    for (const size_t i : awaited)
      if (waiting_[i]++ == 0) heard_[static_cast<size_t>(near_[i].rank())] = nowSeconds();
    ledger_.park(number, std::move(awaited));
    record() = nullptr;
    began() = 0;
    return true;
  } catch (const std::exception&) { return false; }  // no memory: lights what others may hide
}

void PeerExchange::sendDepths(int number, const render::Tile& tile, const Image& image) {
  const int column = number % columns_, row = number / columns_;
  std::vector<int> to;
  {
    const std::lock_guard lock(mutex_);
    for (size_t i = 0; i < near_.size(); ++i)
      if (mayHide(i, column, row) && depths_.send(near_[i].rank(), number)) to.push_back(near_[i].rank());
  }
  std::vector<std::byte> packed;
  if (!to.empty()) packed = packDepths(image, tile, own_, snapshot_->camera.largestWins);
  const std::lock_guard lock(mutex_);
  for (const int rank : to) {
    TileDepths& batch = batches_[rank];
    batch.tiles.push_back(number), batch.packed.push_back(packed);
  }
  const size_t enough = ledger_.hasShared() ? kBatch : 1;
  for (auto& [rank, batch] : batches_) {
    if (batch.tiles.size() < enough) continue;
    batch.round = scene_.round;
    sendTo(rank, std::exchange(batch, {}));
  }
}

const render::HiddenPixels& PeerExchange::hidden(const render::Tile& tile, const Image& image) noexcept {
  static constexpr render::HiddenPixels kNone;
  TileRecord* const seen = record();
  if (!seen) return kNone;
  if (seen->hidden) return *seen->hidden;
  render::HiddenPixels& hidden = seen->hidden.emplace();
  const int number = tileOf(tile), column = number % columns_, row = number / columns_;
  for (size_t i = 0; i < near_.size(); ++i) {
    if (!mayBeHidden(i, column, row)) continue;
    const PeerDepths::Packed packed = [&] {
      const std::lock_guard lock(mutex_);
      return depths_.find(near_[i].rank(), number);
    }();
    try {
      if (packed)
        addHidden(*packed, near_[i].drawn(), image, tile, snapshot_->camera.largestWins, depthStep_, hidden);
    } catch (const std::exception&) {}  // malformed: lights what it may hide
  }
  return hidden;
}

}  // namespace gluray::cluster
