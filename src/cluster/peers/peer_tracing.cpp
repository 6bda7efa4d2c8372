// PeerExchange on the tracing threads of one image.
#include "base/clock.h"
#include "cluster/peers/peer_exchange.h"
#include "render/remote/depths_first.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

namespace gluray::cluster {
namespace {

constexpr auto kLook = std::chrono::milliseconds(20);

}  // namespace

TileRecord*& PeerExchange::record() {
  thread_local TileRecord* record = nullptr;
  return record;
}

double& PeerExchange::began() {
  thread_local double began = 0;
  return began;
}

void PeerExchange::spent(PeerTimes::Kind kind) noexcept {
  double& since = began();
  if (since > 0) times_.add(kind, nowSeconds() - since);
  since = 0;
}

void PeerExchange::waitForPeers(Lock& lock) {
  const double since = nowSeconds();
  const PeerTimes::Kind kind = ledger_.awaitsDepths() ? PeerTimes::depths : PeerTimes::answers;
  changed_.wait(lock);
  times_.add(kind, nowSeconds() - since);
}

void PeerExchange::beginEmpty(const scene::Snapshot& snapshot) {
  meet(snapshot, {glm::vec3(1), glm::vec3(0)}, nullptr);
}

void PeerExchange::begin(const render::FrameData& frame) {
  meet(*frame.snapshot, frame.world->lightBounds(), &frame);
  answers_.emplace(frame);
  changed_.notify_all();  // queries may have come before
}

void PeerExchange::meet(const scene::Snapshot& snapshot, const accel::Bounds& bounds,
                        const render::FrameData* frame) {
  SceneHeld scene;
  scene.address = {program_, self_, self_};
  scene.frame = frameOf(snapshot), scene.swaps = snapshot.swaps;
  scene.viewport = snapshot.camera.viewport;
  scene.clipFromEye = snapshot.camera.clipFromEye, scene.eyeFromWorld = snapshot.eyeFromWorld;
  if (snapshot.secondaryScene) scene.viewFromWorld = snapshot.secondaryScene->viewFromWorld;
  scene.lower = bounds.lower, scene.upper = bounds.upper;
  own_ = frame && frame->seen ? frame->drawn : render::DrawnPart{};
  depthStep_ = frame ? render::depthStep(*frame) : 0;
  scene.drawn = own_;
  const PartState own = parts_.show(snapshot, frame);
  scene.changes = own.changes, scene.eyeFromLargest = own.eyeFromLargest;

  Lock lock(mutex_);
  snapshot_ = &snapshot;
  answers_.reset();
  again_ = false, met_ = false;
  setScene(scene);
  const double since = nowSeconds();
  while (!isCancelled() && !closed_ && meetings_.awaits(nowSeconds())) changed_.wait_for(lock, kLook);
  times_.add(PeerTimes::scenes, nowSeconds() - since);
  for (const int rank : meetings_.newlyLate())
    say_(peerName(rank) + " draws nothing here: only the other ranks contribute to light effects");
  addNear();
}

/// Queries that peers have sent stay if this is the scene that they ask about.
void PeerExchange::setScene(SceneHeld scene) {
  scene.round = scene_.round;
  if (encoded(scene) != encoded(scene_)) refuseAll();
  scene.round = scene_.round;
  scene_ = scene;
  depths_.begin(scene_.round);
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
  met_ = true;
  std::vector<PartState> parts = {{self_, scene_.changes, scene_.eyeFromLargest}};
  for (const NearPeer& peer : near_) {
    const SceneHeld& scene = meetings_.sceneOf(peer.rank());
    parts.push_back({peer.rank(), scene.changes, meetings_.eyeFromPeer(peer.rank()) * scene.eyeFromLargest});
  }
  changes_ = parts_.changed(std::move(parts));
}

void PeerExchange::begin(const Image& image) noexcept {
  const render::Tiles all(image, render::kTileSize);
  const auto* const wanted = snapshot_->lightSampling.tiles.get();
  tiles_.clear();
  for (int tile = 0; tile < all.columns * all.rows; ++tile)
    if (!wanted || static_cast<size_t>(tile) >= wanted->size() || (*wanted)[static_cast<size_t>(tile)])
      tiles_.push_back(tile);
  const std::lock_guard lock(mutex_);
  ++attempt_;
  orderTiles(all);
  for (const auto& [rank, batch] : std::exchange(batches_, {}))
    for (const int tile : batch.tiles) depths_.unsend(rank, tile);
  colored_ = 0;
}

bool PeerExchange::answersOne(Lock& lock) noexcept {
  if (queries_.empty() || !answers_) return false;
  const OcclusionQueries queries = std::move(queries_.front());
  queries_.pop_front();
  lock.unlock();
  answer(queries);
  lock.lock();
  return true;
}

int PeerExchange::nextTile() noexcept {
  Lock lock(mutex_);
  for (;;) {
    if (ends()) return -1;
    if (answersOne(lock)) continue;
    const TileLedger::Work work = ledger_.takeWork();
    if (work.record) {
      record() = work.record;
      began() = nowSeconds();
      return work.tile;
    }
    if (ledger_.isDone()) return -1;
    waitForPeers(lock);
  }
}

void PeerExchange::done(int tile, double, bool seenThrough) noexcept {
  spent(PeerTimes::light);
  if (!record()) return;  // coloured: its light was collected before
  TileRecord& traced = *std::exchange(record(), nullptr);
  const std::lock_guard lock(mutex_);
  if (seenThrough && averages_) averages_ = false, again_ = true;
  if (!traced.replays() && traced.asks() && !ends())
    sendQueries(tile, traced, nowSeconds());
  else
    ledger_.finish(tile);
  if (ledger_.isDone() || again_) changed_.notify_all();
}

void PeerExchange::collected(const render::VisibilityBuffer&, int tile, double seconds) noexcept {
  done(tile, seconds, false);
}

/// Each process has a visibility buffer of its own: its pixels are those of the process's surfaces.
bool PeerExchange::complete(render::VisibilityBuffer&) noexcept {
  const std::lock_guard lock(mutex_);
  return !ends();
}

int PeerExchange::nextToColor() noexcept {
  Lock lock(mutex_);
  while (!ends() && answersOne(lock)) {}
  if (ends() || colored_ == tiles_.size()) return -1;
  began() = nowSeconds();
  return tiles_[colored_++];
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
  TileRecord* const asking = record();
  if (!asking) return blocked;
  if (asking->replays()) return asking->combine(blocked, passing);
  const size_t number = asking->add(blocked);
  uint32_t open = 0;
  for (int i = 0; i < accel::kLanes; ++i) open |= static_cast<uint32_t>(query.valid[i] != 0) << i;
  open &= ~blocked;
  for (size_t i = 0; open && i < near_.size(); ++i)
    if (const uint32_t lanes = near_[i].mayMeet(query.rays, open))
      asking->ask(number, static_cast<int>(i), near_[i].packetOf(query, lanes));
  return blocked;
}

bool PeerExchange::recall(uint32_t& blocked) noexcept { return record() && record()->recall(blocked); }

bool PeerExchange::isReplaying() const noexcept { return record() && record()->replays(); }

void PeerExchange::answer(const OcclusionQueries& queries) const noexcept {
  OcclusionReplies replies{{}, queries.id, false, {}};
  try {
    QueryReader in(queries.rays);
    AnswerWriter out;
    QueryPacket packet;
    while (in.nextPacket(packet)) {
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
    replies.answers = out.takeBytes();
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

void PeerExchange::hold(const std::function<void()>& whole) noexcept {
  try {
    Lock lock(mutex_);
    if (again_ && !isCancelled() && !closed_) return;
    if (!isCancelled() && !closed_) {
      lock.unlock();
      whole();
      if (snapshot_->lightSampling.mode == scene::LightSampling::Mode::moving) parts_.keep();
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

}  // namespace gluray::cluster
