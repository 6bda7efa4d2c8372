#include "cluster/peers/tile_ledger.h"

namespace gluray::cluster {

void TileLedger::reset(std::vector<int> tiles, size_t peers) {
  fresh_.assign(tiles.begin(), tiles.end());
  ready_.clear();
  at_.clear();
  left_ = tiles.size();
  peers_ = peers;
}

TileLedger::Work TileLedger::takeWork() {
  if (!ready_.empty()) {
    const int tile = ready_.front();
    ready_.pop_front();
    return {tile, at_.at(tile).record.get()};
  }
  if (fresh_.empty()) return {};
  const int tile = fresh_.front();
  fresh_.pop_front();
  Open& open = at_[tile];
  open.record = std::make_unique<TileRecord>(peers_);
  return {tile, open.record.get()};
}

void TileLedger::finish(int tile) {
  at_.erase(tile);
  --left_;
}

bool TileLedger::answer(int tile, int peer, std::span<const std::byte> answers) {
  const auto found = at_.find(tile);
  if (found == at_.end() || found->second.missing == 0) throw Malformed("an answer that nobody waits for");
  found->second.record->answer(peer, answers);
  if (--found->second.missing > 0) return false;
  found->second.record->replay();
  ready_.push_back(tile);
  return true;
}

}  // namespace gluray::cluster
