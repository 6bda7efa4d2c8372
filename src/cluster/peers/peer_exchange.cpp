#include "cluster/peers/peer_exchange.h"

#include "base/clock.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

namespace gluray::cluster {
namespace {

constexpr int kMaxRefusals = 3;  // of an image

}  // namespace

PeerExchange::PeerExchange(Hash128 program, int self, int ranks, Send send, Say say)
    : program_(program),
      self_(self),
      send_(std::move(send)),
      say_(std::move(say)),
      meetings_(self, ranks),
      asking_(static_cast<size_t>(ranks)),
      heard_(static_cast<size_t>(ranks)),
      depths_(ranks) {
  scene_.address = {program, self, self};
}

void PeerExchange::joins(int rank) {
  const std::lock_guard lock(mutex_);
  meetings_.joins(rank);
  depths_.forget(rank);
  if (held_) sendTo(rank, scene_);  // what was sent before did not reach it
  changed_.notify_all();
}

void PeerExchange::leaves(int rank) {
  const std::lock_guard lock(mutex_);
  if (nearOf(rank) < near_.size() && !ledger_.isDone()) drop(rank, "is gone");
  meetings_.leaves(rank);
  depths_.forget(rank);
  asking_[static_cast<size_t>(rank)] = false;
  changed_.notify_all();
}

void PeerExchange::receive(const SceneComes& coming, double now) {
  const std::lock_guard lock(mutex_);
  meetings_.comes(coming.address.from, coming.viewport, now);
  changed_.notify_all();
}

void PeerExchange::receive(const SceneHeld& scene, double now) {
  const std::lock_guard lock(mutex_);
  meetings_.holds(scene);
  depths_.holds(scene.address.from, scene.round);
  asking_[static_cast<size_t>(scene.address.from)] = true;
  if (met_ && nearOf(scene.address.from) == near_.size())
    sendTo(scene.address.from, NoDepths{{}, scene_.round});
  heard_[static_cast<size_t>(scene.address.from)] = now;
  changed_.notify_all();
}

void PeerExchange::receive(OcclusionQueries queries, double now) {
  const std::lock_guard lock(mutex_);
  heard_[static_cast<size_t>(queries.address.from)] = now;
  // Between two images of one view they wait for the second.
  if (queries.round != scene_.round || (!held_ && !coming_))
    return sendTo(queries.address.from, OcclusionReplies{{}, queries.id, true, {}});
  queries_.push_back(std::move(queries));
  changed_.notify_all();
}

void PeerExchange::receive(const OcclusionReplies& replies, double now) {
  const std::lock_guard lock(mutex_);
  const int rank = replies.address.from;
  const size_t near = nearOf(rank);
  if (replies.id >> 32 != attempt_ || near == near_.size() || ends()) return;  // of an earlier image
  if (replies.refused) {
    // It has another scene by now: of this view again, or of its next image.
    if (++refusals_ > kMaxRefusals) return drop(rank, "has gone on to its next image");
    again_ = true;
    return changed_.notify_all();
  }
  try {
    ledger_.answer(static_cast<int>(replies.id & 0xFFFF'FFFF), static_cast<int>(near), replies.answers);
    heard_[static_cast<size_t>(rank)] = now;
    --waiting_[near];
    changed_.notify_all();
  } catch (const Malformed& error) { drop(rank, error.what()); }
}

void PeerExchange::receive(const DoneAsking& done, double now) {
  const std::lock_guard lock(mutex_);
  heard_[static_cast<size_t>(done.address.from)] = now;
  asking_[static_cast<size_t>(done.address.from)] = false;
  meetings_.ends(done.address.from);
  endDepths(done.address.from);
  changed_.notify_all();
}

void PeerExchange::receive(const StillHere& here, double now) {
  const std::lock_guard lock(mutex_);
  heard_[static_cast<size_t>(here.address.from)] = now;
}

void PeerExchange::announce(const std::optional<ViewName>& shown) {
  const std::lock_guard lock(mutex_);
  ++announced_;
  coming_ = shown;
  saidComing_ = 0;  // at the next tick
  changed_.notify_all();
}

void PeerExchange::tick(double now) {
  const std::lock_guard lock(mutex_);
  if (coming_ && now - saidComing_ > Meetings::kSayEvery) {
    saidComing_ = now;
    sendToAll(SceneComes{{}, coming_->viewport});
  }
  if (held_ && now - saidHere_ > Meetings::kSayEvery) {
    saidHere_ = now;
    for (int rank = 0; rank < meetings_.ranks(); ++rank)
      if (asking_[static_cast<size_t>(rank)] || nearOf(rank) < near_.size()) sendTo(rank, StillHere{});
  }
  for (size_t i = 0; i < near_.size() && !ends(); ++i)
    if (waiting_[i] > 0 && isSilent(near_[i].rank(), now)) drop(near_[i].rank(), "does not answer");
}

bool PeerExchange::isSilent(int rank, double now) const {
  return now - heard_[static_cast<size_t>(rank)] > Meetings::kPatience;
}

void PeerExchange::cancel() {
  const std::lock_guard lock(mutex_);
  cancelled_ = announced_;
  coming_.reset();
  changed_.notify_all();
}

void PeerExchange::close() {
  const std::lock_guard lock(mutex_);
  closed_ = true;
  changed_.notify_all();
}

void PeerExchange::drop(int rank, const std::string& why) {
  meetings_.fail(rank);
  again_ = true;
  say_(peerName(rank) + " " + why +
       ": its surfaces have no light effects on other ranks until it draws again");
  changed_.notify_all();
}

void PeerExchange::start(bool averages, bool meets, std::function<void()> traced) {
  const std::lock_guard lock(mutex_);
  ++started_;
  averages_ = averages;
  traced_ = std::move(traced);
  refusals_ = 0;
  if (!meets) refuseAll();
}

void PeerExchange::refuseAll() {
  ++scene_.round;
  for (const OcclusionQueries& queries : std::exchange(queries_, {}))
    sendTo(queries.address.from, OcclusionReplies{{}, queries.id, true, {}});
}

void PeerExchange::finish() noexcept {
  try {
    const std::lock_guard lock(mutex_);
    if (held_) sendToAll(DoneAsking{});
    held_ = false;
    again_ = false;
    near_.clear(), met_ = false;
    answers_.reset();
    if (announced_ == started_) coming_.reset(), refuseAll();
    meetings_.end();
  } catch (const std::exception&) {}  // no memory: peers go on without an answer
}

size_t PeerExchange::nearOf(int rank) const {
  return static_cast<size_t>(std::ranges::find(near_, rank, &NearPeer::rank) - near_.begin());
}

}  // namespace gluray::cluster
