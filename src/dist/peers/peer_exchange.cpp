#include "dist/peers/peer_exchange.h"

#include "base/clock.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

namespace gluray::dist {
namespace {

constexpr double kSayEvery = 0.2;  // seconds
constexpr int kMostRefusals = 3;   // of a picture
constexpr auto kLook = std::chrono::milliseconds(20);

thread_local TileRecord* record = nullptr;  // of the tile that this thread traces

std::string nameOf(int rank) { return "rank " + std::to_string(rank) + " of the program"; }

}  // namespace

PeerExchange::PeerExchange(Hash128 program, int self, int ranks, Send send, Say say)
    : program_(program),
      self_(self),
      send_(std::move(send)),
      say_(std::move(say)),
      meetings_(self, ranks),
      asking_(static_cast<size_t>(ranks)),
      heard_(static_cast<size_t>(ranks)) {
  scene_.address = {program, self, self};
}

template <class M>
void PeerExchange::sendTo(int peer, M message) const {
  message.address = {program_, self_, peer};
  send_(peer, forRanks(message));
}

template <class M>
void PeerExchange::sendToAll(const M& message) const {
  for (int rank = 0; rank < meetings_.ranks(); ++rank)
    if (rank != self_) sendTo(rank, message);
}

void PeerExchange::joins(int rank) {
  const std::lock_guard lock(mutex_);
  meetings_.joins(rank);
  if (held_) sendTo(rank, scene_);  // what was sent before did not reach it
  changed_.notify_all();
}

void PeerExchange::leaves(int rank) {
  const std::lock_guard lock(mutex_);
  if (nearOf(rank) < near_.size() && !ledger_.isDone()) drop(rank, "is gone");
  meetings_.leaves(rank);
  asking_[static_cast<size_t>(rank)] = false;
  changed_.notify_all();
}

void PeerExchange::take(const SceneComes& coming, double now) {
  const std::lock_guard lock(mutex_);
  meetings_.comes(coming.address.from, coming.viewport, now);
  changed_.notify_all();
}

void PeerExchange::take(const SceneHeld& scene, double now) {
  const std::lock_guard lock(mutex_);
  meetings_.holds(scene);
  asking_[static_cast<size_t>(scene.address.from)] = true;
  heard_[static_cast<size_t>(scene.address.from)] = now;
  changed_.notify_all();
}

void PeerExchange::take(OcclusionQueries queries, double now) {
  const std::lock_guard lock(mutex_);
  heard_[static_cast<size_t>(queries.address.from)] = now;
  // Between two pictures of one view they wait for the second.
  if (queries.round != scene_.round || (!held_ && !coming_))
    return sendTo(queries.address.from, OcclusionReplies{{}, queries.id, true, {}});
  queries_.push_back(std::move(queries));
  changed_.notify_all();
}

void PeerExchange::take(const OcclusionReplies& replies, double now) {
  const std::lock_guard lock(mutex_);
  const int rank = replies.address.from;
  const size_t near = nearOf(rank);
  if (replies.id >> 32 != attempt_ || near == near_.size() || ends()) return;  // of an earlier picture
  if (replies.refused) {
    // It has another scene by now: of this view again, or of its next picture.
    if (++refusals_ > kMostRefusals) return drop(rank, "has gone on to its next picture");
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

void PeerExchange::take(const DoneAsking& done, double now) {
  const std::lock_guard lock(mutex_);
  heard_[static_cast<size_t>(done.address.from)] = now;
  asking_[static_cast<size_t>(done.address.from)] = false;
  changed_.notify_all();
}

void PeerExchange::take(const StillHere& here, double now) {
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
  if (coming_ && now - saidComing_ > kSayEvery) {
    saidComing_ = now;
    sendToAll(SceneComes{{}, coming_->viewport});
  }
  if (held_ && now - saidHere_ > kSayEvery) {
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
  say_(nameOf(rank) + " " + why + ": its surfaces give no light and no shadow until it draws again");
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
    near_.clear();
    answers_.reset();
    if (announced_ == started_) coming_.reset(), refuseAll();
    meetings_.end();
  } catch (const std::exception&) {}  // no memory: peers go on without an answer
}

size_t PeerExchange::nearOf(int rank) const {
  return static_cast<size_t>(std::ranges::find(near_, rank, &NearPeer::rank) - near_.begin());
}

void PeerExchange::beginEmpty(const scene::Snapshot& snapshot) {
  meet(snapshot, {glm::vec3(1), glm::vec3(0)});
}

void PeerExchange::begin(const render::FrameData& frame) {
  meet(*frame.snapshot, frame.world->lightBounds());
  answers_.emplace(frame);
  changed_.notify_all();  // queries may have come before
}

void PeerExchange::meet(const scene::Snapshot& snapshot, const accel::Bounds& bounds) {
  SceneHeld scene;
  scene.address = {program_, self_, self_};
  scene.frame = snapshot.frame, scene.viewport = snapshot.camera.viewport;
  scene.clipFromEye = snapshot.camera.clipFromEye, scene.eyeFromWorld = snapshot.eyeFromWorld;
  if (snapshot.surroundings) scene.viewFromWorld = snapshot.surroundings->viewFromWorld;
  scene.lower = bounds.lower, scene.upper = bounds.upper;

  Lock lock(mutex_);
  snapshot_ = &snapshot;
  answers_.reset();
  again_ = false;
  setScene(scene);
  while (!isCancelled() && !closed_ && meetings_.awaits(nowSeconds())) changed_.wait_for(lock, kLook);
  for (const int rank : meetings_.newlyLate())
    say_(nameOf(rank) + " draws nothing here: light and shadow come from the others");
  addNear();
}

/// Queries that peers have sent stay if this is the scene that they ask about.
void PeerExchange::setScene(SceneHeld scene) {
  scene.round = scene_.round;
  if (encoded(scene) != encoded(scene_)) refuseAll();
  scene.round = scene_.round;
  scene_ = scene;
  held_ = true;
  if (announced_ == started_) coming_.reset();
  meetings_.begin(scene_, nowSeconds());
  sendToAll(scene_);
}

void PeerExchange::addNear() {
  near_.clear();
  bounds_ = {scene_.lower, scene_.upper};
  for (int rank = 0; rank < meetings_.ranks(); ++rank) {
    if (meetings_.stateOf(rank, nowSeconds()) != Meetings::State::here) continue;
    const SceneHeld& scene = meetings_.sceneOf(rank);
    if (accel::Bounds{scene.lower, scene.upper}.empty()) continue;
    const NearPeer& peer = near_.emplace_back(scene_, scene, meetings_.eyeFromPeer(rank));
    if (bounds_.empty()) bounds_ = peer.bounds();
    bounds_.lower = glm::min(bounds_.lower, peer.bounds().lower);
    bounds_.upper = glm::max(bounds_.upper, peer.bounds().upper);
  }
  waiting_.assign(near_.size(), 0);
}

void PeerExchange::begin(const Image& image) noexcept {
  const render::Tiles all(image, render::kTileSize);
  const auto* const wanted = snapshot_->lightSampling.tiles.get();
  std::vector<int> tiles;
  for (int tile = 0; tile < all.columns * all.rows; ++tile)
    if (!wanted || static_cast<size_t>(tile) >= wanted->size() || (*wanted)[static_cast<size_t>(tile)])
      tiles.push_back(tile);
  const std::lock_guard lock(mutex_);
  ++attempt_;
  ledger_.reset(std::move(tiles), near_.size());
}

int PeerExchange::next() noexcept {
  Lock lock(mutex_);
  for (;;) {
    if (ends()) return -1;
    if (!queries_.empty() && answers_) {
      const OcclusionQueries queries = std::move(queries_.front());
      queries_.pop_front();
      lock.unlock();
      answer(queries);
      lock.lock();
      continue;
    }
    const TileLedger::Work work = ledger_.take();
    if (work.record) {
      record = work.record;
      return work.tile;
    }
    if (ledger_.isDone()) return -1;
    changed_.wait(lock);
  }
}

void PeerExchange::done(int tile, double, bool seenThrough) noexcept {
  TileRecord& traced = *std::exchange(record, nullptr);
  const std::lock_guard lock(mutex_);
  if (seenThrough && averages_) averages_ = false, again_ = true;
  if (!traced.replays() && traced.asks() && !ends())
    sendQueries(tile, traced, nowSeconds());
  else
    ledger_.finish(tile);
  changed_.notify_all();
}

void PeerExchange::sendQueries(int tile, TileRecord& traced, double now) {
  size_t answers = 0;
  for (size_t i = 0; i < near_.size(); ++i) {
    if (traced.raysFor(static_cast<int>(i)) == 0) continue;
    ++answers;
    if (waiting_[i]++ == 0) heard_[static_cast<size_t>(near_[i].rank())] = now;
    const uint64_t id = attempt_ << 32 | static_cast<uint32_t>(tile);
    sendTo(near_[i].rank(),
           OcclusionQueries{{}, near_[i].round(), id, traced.queriesFor(static_cast<int>(i))});
  }
  ledger_.wait(tile, answers);
}

uint32_t PeerExchange::occluded(const render::RemoteQuery& query, uint32_t blocked,
                                render::Passing passing) noexcept {
  if (!record) return blocked;
  if (record->replays()) return record->combine(blocked, passing);
  const size_t number = record->add(blocked);
  uint32_t open = 0;
  for (int i = 0; i < accel::kLanes; ++i) open |= static_cast<uint32_t>(query.valid[i] != 0) << i;
  open &= ~blocked;
  for (size_t i = 0; open && i < near_.size(); ++i)
    if (const uint32_t lanes = near_[i].mayMeet(query.rays, open))
      record->ask(number, static_cast<int>(i), near_[i].packetOf(query, lanes));
  return blocked;
}

bool PeerExchange::recall(uint32_t& blocked) noexcept { return record && record->recall(blocked); }

bool PeerExchange::isReplaying() const noexcept { return record && record->replays(); }

void PeerExchange::answer(const OcclusionQueries& queries) const noexcept {
  OcclusionReplies replies{{}, queries.id, false, {}};
  try {
    QueryReader in(queries.rays);
    AnswerWriter out;
    QueryPacket packet;
    while (in.next(packet)) {
      alignas(64) int32_t valid[accel::kLanes];
      for (int i = 0; i < accel::kLanes; ++i) valid[i] = packet.lanes >> i & 1 ? -1 : 0;
      glm::vec3 through[accel::kLanes];
      AnswerPacket answers;
      answers.blocked =
          answers_->occluded(valid, packet.rays, packet.kind, packet.lamp ? &*packet.lamp : nullptr, through);
      const uint32_t passed = packet.lanes & ~answers.blocked;
      for (int i = 0; i < accel::kLanes; ++i) {
        if (!(passed >> i & 1) || through[i] == glm::vec3(1)) continue;
        answers.partly |= 1u << i;
        answers.through[static_cast<size_t>(i)] = through[i];
      }
      out.add(answers);
    }
    replies.answers = out.take();
  } catch (const std::exception&) { replies.refused = true; }
  try {
    sendTo(queries.address.from, std::move(replies));
  } catch (const std::exception&) {}  // no memory: the peer goes on without an answer
}

void PeerExchange::answerAll(std::deque<OcclusionQueries> queries) const {
  tbb::parallel_for(size_t{0}, queries.size(), [&](size_t i) {
    const render::FloatGuard guard;
    answer(queries[i]);
  });
}

bool PeerExchange::isAsked(double now) const {
  for (int rank = 0; rank < meetings_.ranks(); ++rank)
    if (asking_[static_cast<size_t>(rank)] && meetings_.holdsTheSame(rank) && !isSilent(rank, now))
      return true;
  return false;
}

void PeerExchange::hold() noexcept {
  try {
    Lock lock(mutex_);
    if (again_ && !isCancelled() && !closed_) return;
    if (!isCancelled() && !closed_) {
      lock.unlock();
      traced_();
      lock.lock();
    }
    sendToAll(DoneAsking{});
    serve(lock);
  } catch (const std::exception&) {}  // no memory: peers go on without this rank
}

void PeerExchange::serve(Lock& lock) {
  while (!closed_) {
    if (!queries_.empty()) {
      std::deque<OcclusionQueries> queries = std::exchange(queries_, {});
      lock.unlock();
      answerAll(std::move(queries));
      lock.lock();
    } else if (announced_ > started_) {
      const bool sameView = coming_ == ViewName{scene_.frame, scene_.viewport};
      if (sameView || !isAsked(nowSeconds())) return;
      changed_.wait_for(lock, kLook);
    } else {
      changed_.wait(lock);
    }
  }
}

}  // namespace gluray::dist
