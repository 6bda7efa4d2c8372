// Finds the peers with a part of the view that a rank traces. Ranks count frames independently; the constant
// differences of their counts are determined. Peers that draw nothing, or do not answer, are awaited once.
// One thread at a time.
#pragma once
#include "cluster/messages/peer_messages.h"

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace gluray::cluster {

class Meetings {
 public:
  /// Seconds until a rank continues without a peer.
  static constexpr double kPatience = 1;
  /// Seconds between signs of life of a working peer.
  static constexpr double kSayEvery = 0.2;

  Meetings(int self, int ranks) : self_(self), ranks_(ranks) {}

  void joins(int rank) { at(rank) = {}; }
  void leaves(int rank);
  /// The peer is building a scene of this view, and is awaited while it reports that.
  void comes(int rank, const glm::ivec4& viewport, double now);
  /// The peer has this scene now.
  void holds(const SceneHeld& scene);
  /// The peer has the image of its scene, and no longer waits.
  void ends(int rank) { at(rank).waits = false; }
  /// The rank itself has this scene now; matches it with scenes of the same view.
  void begin(const SceneHeld& own, double now);
  /// The image is there.
  void end() { ended_ = arrivals_; }
  /// The peer has not answered: ignores it until it has another scene.
  void fail(int rank) { at(rank).failed = at(rank).late = true; }

  enum class State : uint8_t {
    awaited,
    here,    // has a part of the view
    absent,  // probably has no part of it
  };
  State stateOf(int rank, double now);
  /// Whether the peer has the same view and frame as the rank.
  bool holdsTheSame(int rank) const;
  /// Whether some peer is awaited.
  bool awaits(double now);
  /// Scene of a peer that is here.
  const SceneHeld& sceneOf(int rank) const { return *peers_.at(rank).scene; }
  /// From the peer's eye space to the rank's own.
  glm::dmat4 eyeFromPeer(int rank) const;
  /// Peers that have become late since the last call.
  std::vector<int> newlyLate();
  int self() const { return self_; }
  int ranks() const { return ranks_; }

 private:
  struct Peer {
    std::optional<SceneHeld> scene;
    std::optional<glm::ivec4> coming;
    double comesAt = 0;
    uint64_t arrival = 0;    // when the scene came, counted in arrivals
    bool waits = false;      // for the image of the scene
    int64_t ahead = 0;       // its frame count minus ours
    int64_t swapsAhead = 0;  // its swap count minus ours
    bool metBefore = false;  // so that both are known
    bool late = false, failed = false, told = false;
  };
  Peer& at(int rank) { return peers_[rank]; }
  bool showsView(const SceneHeld& scene) const;
  bool isNow(const Peer& peer) const;
  bool mayBeNow(const Peer& peer) const;
  int64_t swapsAhead(const Peer& peer) const { return static_cast<int64_t>(peer.scene->swaps - own_->swaps); }
  bool comesHere(const Peer& peer) const { return own_ && peer.coming == own_->viewport; }

  const int self_, ranks_;
  std::unordered_map<int, Peer> peers_;
  std::optional<SceneHeld> own_;
  double began_ = 0;
  uint64_t arrivals_ = 0, ended_ = 0;
};

/// For messages to the user.
inline std::string peerName(int rank) { return "rank " + std::to_string(rank) + " of the program"; }

}  // namespace gluray::cluster
