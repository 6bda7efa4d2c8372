#include "cluster/shares/tile_shares.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace gluray::cluster {
namespace {

constexpr size_t kPart = 3;  // a rank gets 1 / kPart of what is left of its share

/// Tiles that keep a rank's threads busy until more of them arrive.
size_t enough(const Tracer& tracer) { return 2 * static_cast<size_t>(std::max(tracer.threads, 1)); }

float strengthOf(const Tracer& t) {
  return t.here ? static_cast<float>(std::max(t.threads, 1)) * std::max(t.speed, 1e-3f) : 0;
}

}  // namespace

TileShares::TileShares(const std::vector<float>& costs, const std::vector<unsigned char>* wanted,
                       const std::vector<Tracer>& tracers)
    : costs_(costs), holder_(costs.size(), kNobody) {
  for (const Tracer& tracer : tracers) ranks_.push_back({tracer, {}, 0});
  double all = 0, strength = 0;
  for (size_t tile = 0; tile < costs.size(); ++tile) {
    if (wanted && tile < wanted->size() && !(*wanted)[tile]) {
      holder_[tile] = kNotWanted;
    } else {
      all += costs[tile];
      ++left_;
    }
  }
  for (const Tracer& tracer : tracers) strength += strengthOf(tracer);
  if (!(strength > 0)) return;
  size_t rank = 0;
  double before = 0, end = all * strengthOf(tracers[0]) / strength;
  for (size_t tile = 0; tile < costs.size(); ++tile) {
    if (holder_[tile] == kNotWanted) continue;
    // A tile belongs to the share in which its middle lies.
    while ((before + costs[tile] / 2 > end || !tracers[rank].here) && rank + 1 < tracers.size())
      end += all * strengthOf(tracers[++rank]) / strength;
    ranks_[rank].rest.push_back(static_cast<int>(tile));
    before += costs[tile];
  }
}

float TileShares::costOf(const std::vector<int>& tiles) const {
  return std::accumulate(tiles.begin(), tiles.end(), 0.0f,
                         [&](float sum, int tile) { return sum + costs_[static_cast<size_t>(tile)]; });
}

void TileShares::takeFromOthers(Rank& rank) {
  Rank& richest = *std::max_element(ranks_.begin(), ranks_.end(), [&](const Rank& a, const Rank& b) {
    return costOf(a.rest) < costOf(b.rest);
  });
  const auto from = richest.rest.begin() + static_cast<ptrdiff_t>(richest.rest.size() / 2);
  rank.rest.assign(from, richest.rest.end());
  richest.rest.erase(from, richest.rest.end());
}

std::vector<int> TileShares::more(int number) {
  Rank& rank = ranks_[static_cast<size_t>(number)];
  const size_t low = enough(rank.tracer);
  if (!rank.takes() || rank.pending >= low) return {};
  if (rank.rest.empty()) takeFromOthers(rank);
  const auto end = rank.rest.begin() + static_cast<ptrdiff_t>(std::min(
                                           rank.rest.size(), std::max(low, rank.rest.size() / kPart)));
  const std::vector<int> tiles(rank.rest.begin(), end);
  rank.rest.erase(rank.rest.begin(), end);
  rank.pending += tiles.size();
  for (const int tile : tiles) holder_[static_cast<size_t>(tile)] = number;
  return tiles;
}

bool TileShares::finish(int tile) {
  if (tile < 0 || static_cast<size_t>(tile) >= holder_.size()) return false;
  int& holder = holder_[static_cast<size_t>(tile)];
  if (holder == kTraced || holder == kNotWanted) return false;
  if (holder != kNobody) {
    --ranks_[static_cast<size_t>(holder)].pending;
  } else {
    // Of a rank that was thought gone.
    for (Rank& rank : ranks_) std::erase(rank.rest, tile);
  }
  holder = kTraced;
  --left_;
  return true;
}

void TileShares::giveBack(int number) {
  Rank& slow = ranks_[static_cast<size_t>(number)];
  std::vector<int> tiles = std::exchange(slow.rest, {});
  slow.pending = 0, slow.paused = true;
  for (size_t tile = 0; tile < holder_.size(); ++tile)
    if (holder_[tile] == number) {
      holder_[tile] = kNobody;
      tiles.push_back(static_cast<int>(tile));
    }
  hand(std::move(tiles), number);
}

void TileShares::drop(int number) {
  ranks_[static_cast<size_t>(number)].tracer.here = false;
  giveBack(number);
}

bool TileShares::isIdle(int number) const {
  const Rank& rank = ranks_[static_cast<size_t>(number)];
  return rank.takes() && rank.pending == 0;
}

void TileShares::hand(std::vector<int> tiles, int notTo) {
  const size_t other = static_cast<size_t>(notTo);
  for (size_t i = 1; i <= ranks_.size(); ++i) {
    Rank& heir = ranks_[(other + i) % ranks_.size()];  // the rank itself comes last
    if (!heir.takes()) continue;
    heir.rest.insert(heir.rest.end(), tiles.begin(), tiles.end());
    return;
  }
}

}  // namespace gluray::cluster
