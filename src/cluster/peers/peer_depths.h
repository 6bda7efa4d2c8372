// The depths that a rank and its peers have given each other for scenes that they hold. Guarded by its
// owner.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace gluray::cluster {

class PeerDepths {
 public:
  using Packed = std::shared_ptr<const std::vector<std::byte>>;  // cluster/peers/tile_depths.h

  explicit PeerDepths(int ranks) : peers_(static_cast<size_t>(ranks)) {}

  /// The peer has come or gone: it has nothing of this rank, and this rank nothing of it.
  void forget(int rank) { at(rank) = {}; }
  /// The peer holds the scene of this round.
  void holds(int rank, uint64_t round) {
    Peer& peer = at(rank);
    if (peer.round != round) peer.tiles.clear();
    peer.round = round;
  }
  /// This rank holds the scene of this round. Peers have no depths of another one.
  void begin(uint64_t round) {
    if (round == own_) return;
    own_ = round;
    for (Peer& peer : peers_) peer.sent.clear();
  }
  /// The peer traces without this rank, and sends no depths of this round.
  void withhold(int rank, uint64_t round) { at(rank).withheld = round; }
  bool withholds(int rank) const {
    const Peer& peer = peers_[static_cast<size_t>(rank)];
    return peer.withheld == peer.round;
  }
  /// Depths of a scene that the peer no longer holds are ignored.
  void receive(int rank, uint64_t round, int tile, std::vector<std::byte> packed) {
    Peer& peer = at(rank);
    if (peer.round == round)
      peer.tiles[tile] = std::make_shared<const std::vector<std::byte>>(std::move(packed));
  }
  /// Null: the peer has not sent them.
  Packed find(int rank, int tile) const {
    const auto& tiles = peers_[static_cast<size_t>(rank)].tiles;
    const auto found = tiles.find(tile);
    return found == tiles.end() ? nullptr : found->second;
  }
  /// Whether the peer needs the tile's depths; afterwards it has them.
  bool send(int rank, int tile) { return at(rank).sent.insert(tile).second; }
  /// It has not got them after all.
  void unsend(int rank, int tile) { at(rank).sent.erase(tile); }

 private:
  struct Peer {
    uint64_t round = 0, withheld = ~uint64_t{0};
    std::unordered_map<int, Packed> tiles;  // that came
    std::unordered_set<int> sent;
  };
  Peer& at(int rank) { return peers_[static_cast<size_t>(rank)]; }

  std::vector<Peer> peers_;
  uint64_t own_ = 0;  // round
};

}  // namespace gluray::cluster
