#include "cluster/peers/tile_ledger.h"

#include <algorithm>

namespace gluray::cluster {

void TileLedger::reset(std::vector<int> shared, std::vector<int> alone, size_t peers) {
  shared_.assign(shared.begin(), shared.end());
  alone_.assign(alone.begin(), alone.end());
  seen_.clear(), ready_.clear();
  at_.clear();
  left_ = shared.size() + alone.size();
  peers_ = peers;
}

TileLedger::Work TileLedger::takeWork() {
  for (std::deque<int>* const queue : {&ready_, &shared_, &seen_, &alone_}) {
    if (queue->empty()) continue;
    const int tile = queue->front();
    queue->pop_front();
    Open& open = at_[tile];
    if (!open.record) open.record = std::make_unique<TileRecord>(peers_);
    return {tile, open.record.get()};
  }
  return {};
}

bool TileLedger::depthsCame(int tile, size_t peer) {
  const auto found = at_.find(tile);
  if (found == at_.end() || std::erase(found->second.awaited, peer) == 0) return false;
  if (found->second.awaited.empty()) seen_.push_back(tile);
  return true;
}

size_t TileLedger::depthsEnd(size_t peer) {
  size_t waited = 0;
  for (auto& [tile, open] : at_) waited += depthsCame(tile, peer);
  return waited;
}

bool TileLedger::awaitsDepths() const {
  return std::ranges::any_of(at_, [](const auto& one) { return !one.second.awaited.empty(); });
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
