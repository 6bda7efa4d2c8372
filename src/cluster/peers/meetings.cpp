#include "cluster/peers/meetings.h"

#include "scene/same_camera.h"

#include <algorithm>

namespace gluray::cluster {
namespace {

/// Seconds after which a peer that waits with another count of frames counts otherwise.
constexpr double kCountsDiffer = 0.1;

std::optional<glm::dmat4> eyeFromEye(const SceneHeld& to, const SceneHeld& from) {
  return scene::eyeFromEye(scene::CameraMatrices{to.clipFromEye, to.eyeFromWorld},
                           scene::CameraMatrices{from.clipFromEye, from.eyeFromWorld});
}

}  // namespace

bool Meetings::showsView(const SceneHeld& scene) const {
  return own_ && own_->viewport == scene.viewport && eyeFromEye(*own_, scene);
}

bool Meetings::isNow(const Peer& peer) const {
  return static_cast<int64_t>(peer.scene->frame - own_->frame) == peer.ahead;
}

/// Ranks that draw nothing of some views count fewer frames of them than others. Swaps are counted by all.
bool Meetings::mayBeNow(const Peer& peer) const {
  return !peer.metBefore || swapsAhead(peer) == peer.swapsAhead;
}

void Meetings::leaves(int rank) {
  at(rank) = {};
  at(rank).late = at(rank).told = true;  // not awaited
}

void Meetings::comes(int rank, const glm::ivec4& viewport, double now) {
  Peer& peer = at(rank);
  peer.coming = viewport, peer.comesAt = now;
  if (comesHere(peer) && !peer.failed) peer.late = peer.told = false;
}

void Meetings::holds(const SceneHeld& scene) {
  Peer& peer = at(scene.address.from);
  peer.scene = scene;
  peer.waits = true;
  peer.coming.reset();
  peer.arrival = ++arrivals_;
  // Whoever draws the view again is awaited again.
  if (showsView(scene)) peer.late = peer.told = false;
}

void Meetings::begin(const SceneHeld& own, double now) {
  own_ = own;
  began_ = now;
  for (auto& [rank, peer] : peers_) peer.failed = false;
}

bool Meetings::holdsTheSame(int rank) const {
  const auto peer = peers_.find(rank);
  return peer != peers_.end() && peer->second.scene && showsView(*peer->second.scene) && isNow(peer->second);
}

Meetings::State Meetings::stateOf(int rank, double now) {
  Peer& peer = at(rank);
  if (rank == self_ || peer.failed || !own_) return State::absent;
  const bool shows = peer.scene && showsView(*peer.scene);
  // Came after the last image: the peer waits for us, too.
  const bool waits = shows && peer.waits && peer.arrival > ended_;
  if (waits && mayBeNow(peer) && now - began_ > kCountsDiffer)
    peer.ahead = static_cast<int64_t>(peer.scene->frame - own_->frame);
  if (holdsTheSame(rank)) {
    peer.metBefore = true;
    peer.swapsAhead = swapsAhead(peer);
    return State::here;
  }
  if (peer.late) return State::absent;
  const double since = comesHere(peer) ? std::max(began_, peer.comesAt) : began_;
  if (now - since <= kPatience) return State::awaited;
  peer.late = true;
  if (waits) peer.metBefore = false;  // the counts have moved apart
  return State::absent;
}

bool Meetings::awaits(double now) {
  bool some = false;
  for (int rank = 0; rank < ranks(); ++rank) some |= stateOf(rank, now) == State::awaited;
  return some;
}

glm::dmat4 Meetings::eyeFromPeer(int rank) const { return *eyeFromEye(*own_, sceneOf(rank)); }

std::vector<int> Meetings::newlyLate() {
  std::vector<int> late;
  for (int rank = 0; rank < ranks(); ++rank)
    if (at(rank).late && !at(rank).told) late.push_back(rank), at(rank).told = true;
  return late;
}

}  // namespace gluray::cluster
