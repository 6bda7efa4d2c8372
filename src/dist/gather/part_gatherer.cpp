#include "dist/gather/part_gatherer.h"

#include <algorithm>
#include <utility>

namespace gluray::dist {
namespace {

constexpr size_t kMostDecided = 16;
constexpr int64_t kKept = 16;         // scenes of a viewport
constexpr size_t kMostPlaces = 1024;  // of all
constexpr double kShowPatience = 10;  // seconds between the end of tracing and the picture that is shown

/// As dist/peers/meetings knows parts.
SceneHeld heldOf(const PartHere& part) {
  SceneHeld scene;
  scene.address = part.address, scene.round = part.round;
  scene.frame = part.view.frame, scene.viewport = part.view.viewport;
  scene.clipFromEye = part.view.clipFromEye, scene.eyeFromWorld = part.view.eyeFromWorld;
  return scene;
}

}  // namespace

PartGatherer::PartGatherer(const Hash128& program, int self, int ranks, Send send, Say say)
    : program_(program),
      self_(self),
      ranks_(ranks),
      send_(std::move(send)),
      say_(std::move(say)),
      heard_(static_cast<size_t>(ranks)) {
  own_.address = {program, self, self};
}

PartGatherer::Place PartGatherer::placeOf(const PartHere& part, uint32_t ordinal) {
  const glm::ivec4& v = part.view.viewport;
  return {v.x, v.y, v.z, v.w, ordinal};
}

/// What is known of peers in the scene before is expected of them in a new one.
Meetings& PartGatherer::meetings(const Place& place) {
  const auto known = meetings_.find(place);
  if (known != meetings_.end()) return known->second;
  Place before = place;
  --before.back();
  const auto last = meetings_.find(before);
  return meetings_.emplace(place, last == meetings_.end() ? Meetings(self_, ranks_) : last->second.next())
      .first->second;
}

/// Contexts that never swap have one frame, and ever more scenes in it.
void PartGatherer::forgetBefore(const Place& place) {
  const bool tooMany = meetings_.size() > kMostPlaces;
  const auto isOld = [&](const Place& other) {
    const bool sameViewport = std::equal(place.begin(), place.end() - 1, other.begin());
    return sameViewport ? other.back() + kKept < place.back() : tooMany;
  };
  std::erase_if(meetings_, [&](const auto& one) { return isOld(one.first); });
  std::erase_if(others_, [&](const auto& one) { return isOld(one.first.first); });
}

void PartGatherer::begin(const TraceRequest& request, double now) {
  end(false, now);
  if (made_.number == request.number)
    made_.isOwed = !made_.ranks.empty();  // more passes
  else if (made_.isOwed)
    giveUpMade();
  atWork(now);
  if (request.part.frame != own_.view.frame) decided_.clear(), scenes_.clear();
  const auto known = std::ranges::find(decided_, request.number, &Decided::number);
  const bool isRetry = number_ == request.number && own_.round > 0;  // it was cancelled before
  own_.view = request.part;
  number_ = request.number;
  if (known != decided_.end()) {
    current_ = static_cast<size_t>(known - decided_.begin());
    if (known->share != Share::shown || theirs_.isNew || theirs_.number != number_) return;
    state_ = State::following;
    at(to_ = theirs_.picture.address.from) = now;
    return;
  }
  if (!isRetry) own_.ordinal = scenes_[placeOf(own_, 0)]++;
  ++own_.round;
  if (decided_.size() >= kMostDecided) decided_.erase(decided_.begin(), decided_.begin() + kMostDecided / 2);
  current_ = decided_.size();
  answer_.reset(), lost_ = false;
  state_ = State::meeting;
  forgetBefore(placeOf(own_, own_.ordinal));
  meetings().begin(heldOf(own_), now);
  for (int rank = 0; rank < ranks_; ++rank)
    if (rank != self_) sendTo(rank, own_);
}

PartGatherer::Share PartGatherer::look(const TraceRequest& request, double now) {
  switch (state_) {
    case State::meeting: return meet(request, now);
    case State::collecting: return collect(now);
    case State::given:
      if (answer_) return decide(*answer_);
      if (!isSilent(to_, now)) return Share::awaited;
      meetings().fail(to_);
      return decide(Share::own);
    case State::following:
      if (!theirs_.isNew && !isSilent(to_, now)) return Share::awaited;
      state_ = State::idle;
      break;
    case State::tracing:
      if (!lost_) return Share::whole;
      lost_ = false;
      decided_.pop_back();
      state_ = State::collecting;
      return collect(now);
    case State::idle: break;
  }
  return decided_[current_].share;
}

std::vector<int> PartGatherer::peersHere(double now) {
  std::vector<int> here;
  for (int rank = 0; rank < ranks_; ++rank)
    if (meetings().stateOf(rank, now) == Meetings::State::here) here.push_back(rank);
  return here;
}

/// Why the parts of these peers and our own make no picture; empty: they do.
std::string PartGatherer::whyNot(const std::vector<int>& peers) {
  const auto blends = [](int rank) { return peerName(rank) + " blends surfaces"; };
  if (own_.view.blends) return blends(self_);
  for (const int rank : peers) {
    const PartView& view = partOf(rank).view;
    if (view.blends) return blends(rank);
    if (view.likeness != own_.view.likeness || meetings().eyeFromPeer(rank) != glm::dmat4(1))
      return peerName(rank) + " draws the view in another way";
  }
  return {};
}

PartGatherer::Share PartGatherer::meet(const TraceRequest& request, double now) {
  if (meetings().awaits(now)) return Share::awaited;
  for (const int rank : meetings().newlyLate())
    say_(peerName(rank) + " draws nothing here: the picture is that of the others");
  const std::vector<int> peers = peersHere(now);
  if (const std::string why = whyNot(peers); !why.empty()) {
    if (std::exchange(saidWhy_, why) != why) say_(why + ": each rank traces its own part");
    return decide(Share::own);
  }
  saidWhy_.clear();
  if (!peers.empty() && peers.front() < self_) {
    to_ = peers.front(), toRound_ = partOf(to_).round;
    at(to_) = now;
    state_ = State::given;
    sendTo(to_, PartGiven{{}, toRound_, number_, request.arrays, request.snapshot});
    return Share::awaited;
  }
  state_ = State::collecting;
  return collect(now);
}

PartGatherer::Share PartGatherer::collect(double now) {
  bool all = true;
  for (const int rank : peersHere(now)) {
    if (given_.contains(rank)) continue;
    if (!isSilent(rank, now)) {
      all = false;
      continue;
    }
    meetings().fail(rank);
    say_(peerName(rank) + " does not give its surfaces: it traces them alone");
  }
  if (!all) return Share::awaited;
  state_ = State::tracing;
  Decided& whole = decided_.emplace_back(Decided{number_, own_.round, Share::whole, {}});
  for (const auto& [rank, part] : given_) whole.parts.push_back(part);
  return Share::whole;
}

PartGatherer::Share PartGatherer::decide(Share share) {
  rest(false, 0);
  decided_.push_back({number_, own_.round, share, {}});
  return share;
}

void PartGatherer::end(bool traced, double now) {
  if (state_ == State::idle) return;
  if (state_ == State::given) sendTo(to_, PartGone{});
  if (state_ == State::following) return void(state_ = State::idle);
  if (state_ == State::tracing && !traced) decided_.pop_back();
  rest(traced, now);
}

/// `traced`: whether our picture shows the parts that peers have given.
void PartGatherer::rest(bool traced, double now) {
  const auto given = std::exchange(given_, {});
  if (traced) {
    made_ = {number_, own_.round, {}, !given.empty(), now, {}};
    for (const auto& [rank, part] : given) made_.ranks.push_back(rank);
  } else {
    for (const auto& [rank, part] : given) sendTo(rank, PartDone{{}, part.round});
  }
  meetings().end();
  state_ = State::idle;
}

/// The program does not show the picture: its parts' ranks trace them.
void PartGatherer::giveUpMade() {
  if (!made_.shown.pixels.empty()) return void(made_.isOwed = false);
  const Made made = std::exchange(made_, {});
  for (const int rank : made.ranks) sendTo(rank, PartDone{{}, made.round});
}

void PartGatherer::atWork(double now) { made_.since = now; }

void PartGatherer::show(uint64_t number, const PartPicture& picture) {
  if (number != made_.number || made_.ranks.empty()) return;
  made_.isOwed = false;
  made_.shown = picture;
  made_.shown.round = made_.round;
  for (const int rank : made_.ranks) sendTo(rank, made_.shown);
}

const PartPicture* PartGatherer::picture() {
  if (theirs_.number != number_ || theirs_.picture.pixels.empty()) return nullptr;
  theirs_.isNew = false;
  return &theirs_.picture;
}

void PartGatherer::joins(int rank) {
  for (auto& [place, meetings] : meetings_) meetings.joins(rank);
  if (state_ != State::idle) sendTo(rank, own_);  // what was sent before did not reach it
}

void PartGatherer::leaves(int rank, double now) {
  loses(rank, now);
  for (auto& [place, meetings] : meetings_) meetings.leaves(rank);
  if (state_ == State::given && rank == to_) answer_ = Share::own;
}

/// The peer may give another part soon.
void PartGatherer::loses(int rank, double now) {
  at(rank) = now;
  if (given_.erase(rank) > 0 && state_ == State::tracing) lost_ = true;
}

void PartGatherer::take(const PartHere& part, double now) {
  const int rank = part.address.from;
  at(rank) = now;
  const Place place = placeOf(part, part.ordinal);
  others_[{place, rank}] = part;
  meetings(place).holds(heldOf(part));
}

void PartGatherer::take(PartGiven part, double now) {
  const int rank = part.address.from;
  at(rank) = now;
  const bool isAwaited = state_ == State::meeting || state_ == State::collecting;
  if (isAwaited && part.round == own_.round) {
    given_[rank] = std::move(part);
    return;
  }
  // It may have asked for its picture once more, after the whole was traced.
  const bool isMade = made_.round == part.round && std::ranges::find(made_.ranks, rank) != made_.ranks.end();
  if (isMade && !made_.shown.pixels.empty()) return sendTo(rank, made_.shown);
  if (!isMade || !made_.isOwed) sendTo(rank, PartDone{{}, part.round});
}

void PartGatherer::take(const PartDone& done, double now) {
  at(done.address.from) = now;
  if (state_ != State::given || done.address.from != to_ || done.round != toRound_) return;
  answer_ = Share::own;
}

void PartGatherer::take(PartPicture picture, double now) {
  const int rank = picture.address.from;
  at(rank) = now;
  const bool isAwaited = state_ == State::given && rank == to_ && picture.round == toRound_;
  const PartPicture& last = theirs_.picture;
  const bool isBetter = !last.pixels.empty() && rank == last.address.from && picture.round == last.round;
  if (!isAwaited && !isBetter) return;
  theirs_ = {isAwaited ? number_ : theirs_.number, true, std::move(picture)};
  if (isAwaited) answer_ = Share::shown;
}

void PartGatherer::take(const PartGone& gone, double now) { loses(gone.address.from, now); }

void PartGatherer::take(const PartAtWork& work, double now) { at(work.address.from) = now; }

void PartGatherer::tick(double now) {
  if (made_.isOwed && now - made_.since > kShowPatience) giveUpMade();
  const bool waits = state_ == State::idle || state_ == State::given || state_ == State::following;
  if ((waits && !made_.isOwed) || now - said_ < Meetings::kSayEvery) return;
  said_ = now;
  for (int rank = 0; rank < ranks_; ++rank)
    if (rank != self_) sendTo(rank, PartAtWork{});
}

}  // namespace gluray::dist
