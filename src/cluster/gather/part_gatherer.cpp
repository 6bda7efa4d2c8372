#include "cluster/gather/part_gatherer.h"

#include <algorithm>
#include <utility>

namespace gluray::cluster {
namespace {

constexpr size_t kMaxDecisions = 16;
constexpr double kShowPatience = 10;  // seconds between the end of tracing and the image that is shown

}  // namespace

PartGatherer::PartGatherer(const Hash128& program, int self, int ranks, Send send, Say say)
    : program_(program),
      self_(self),
      send_(std::move(send)),
      say_(std::move(say)),
      meetings_(self, ranks),
      heard_(static_cast<size_t>(ranks)) {
  own_.address = {program, self, self};
}

void PartGatherer::begin(const TraceRequest& request, double now) {
  end(false, now);
  if (made_.number == request.number)
    made_.isOwed = !made_.ranks.empty();  // more passes
  else if (made_.isOwed)
    giveUpMade();
  atWork(now);
  const auto known = std::ranges::find(decided_, request.number, &Decided::number);
  own_.view = request.part;
  number_ = request.number;
  if (known != decided_.end()) {
    current_ = static_cast<size_t>(known - decided_.begin());
    if (known->share != Share::shown || theirs_.isNew || theirs_.number != number_) return;
    state_ = State::following;
    at(to_ = theirs_.image.address.from) = now;
    return;
  }
  ++own_.round;
  if (decided_.size() >= kMaxDecisions)
    decided_.erase(decided_.begin(), decided_.begin() + kMaxDecisions / 2);
  current_ = decided_.size();
  refusedBy_.clear();
  isShown_ = lost_ = false;
  const Hash128 data = hashBytes(request.arrays.data(), request.arrays.size() * sizeof(Hash128));
  meetings_.begin({own_, request.view, data, request.moving}, now);
  meetAgain();
}

/// Decides anew with whom.
void PartGatherer::meetAgain() {
  if (state_ == State::given) sendTo(to_, PartGone{});
  if (!std::exchange(isOpen_, true)) sendToAll(own_);
  state_ = State::meeting;
}

PartGatherer::Share PartGatherer::findShare(const TraceRequest& request, double now) {
  switch (state_) {
    case State::meeting: return meet(request, now);
    case State::collecting: return collect(request, now);
    case State::given:
      if (isShown_) return decide(Share::shown);
      if (!isSilent(to_, now)) return Share::awaited;
      refusedBy_[to_] = toRound_;
      meetAgain();
      return meet(request, now);
    case State::following:
      if (!theirs_.isNew && !isSilent(to_, now)) return Share::awaited;
      state_ = State::idle;
      break;
    case State::tracing:
      if (!lost_) return Share::whole;
      lost_ = false;
      decided_.pop_back();
      return meet(request, now);
    case State::idle: break;
  }
  return decided_[current_].share;
}

/// Those that may make an image with this rank.
std::vector<int> PartGatherer::peersHere(double now) {
  std::vector<int> peers = meetings_.here(now);
  std::erase_if(peers, [&](int rank) {
    const auto refused = refusedBy_.find(rank);
    return refused != refusedBy_.end() && refused->second == meetings_.partOf(rank).round;
  });
  return peers;
}

/// Why the parts of these peers and our own make no image; empty: they do.
std::string PartGatherer::whyNot(const std::vector<int>& peers) const {
  const auto blends = [](int rank) { return peerName(rank) + " blends surfaces"; };
  if (own_.view.blends) return blends(self_);
  for (const int rank : peers) {
    const PartView& view = meetings_.partOf(rank).view;
    if (view.blends) return blends(rank);
    if (view.likeness != own_.view.likeness || !meetings_.hasOurEyeSpace(rank))
      return peerName(rank) + " draws the view in another way";
  }
  return {};
}

PartGatherer::Share PartGatherer::meet(const TraceRequest& request, double now) {
  state_ = State::meeting;
  if (meetings_.awaits(now)) return Share::awaited;
  for (const int rank : meetings_.newlyLate())
    say_(peerName(rank) + " draws nothing here: the image has only the data of the other ranks");
  const std::vector<int> peers = peersHere(now);
  if (const std::string why = whyNot(peers); !why.empty()) {
    if (std::exchange(saidWhy_, why) != why) say_(why + ": each rank traces its own part");
    return decide(Share::own);  // and stays here, so that the peers see why, too
  }
  saidWhy_.clear();
  if (peers.empty() && !refusedBy_.empty()) return close(), decide(Share::own);
  if (peers.empty() || peers.front() > self_) return collect(request, now);
  giveBack();
  to_ = peers.front(), toRound_ = meetings_.partOf(to_).round;
  at(to_) = now;
  state_ = State::given;
  sendTo(to_, PartGiven{{}, toRound_, number_, request.arrays, request.snapshot});
  return Share::awaited;
}

PartGatherer::Share PartGatherer::collect(const TraceRequest& request, double now) {
  const std::vector<int> peers = peersHere(now);
  if (!peers.empty() && peers.front() < self_) return meet(request, now);
  state_ = State::collecting;
  bool all = true;
  for (const int rank : peers) {
    if (given_.contains(rank)) continue;
    all = all && isSilent(rank, now);
    if (!isSilent(rank, now)) continue;
    meetings_.fail(rank);
    say_(peerName(rank) + " does not send its surfaces: it traces them itself");
  }
  if (!all) return Share::awaited;
  state_ = State::tracing;
  Decided& whole = decided_.emplace_back(Decided{number_, own_.round, Share::whole, {}});
  for (const auto& [rank, part] : given_) whole.parts.push_back(part);
  return Share::whole;
}

PartGatherer::Share PartGatherer::decide(Share share) {
  giveBack();
  state_ = State::idle;
  decided_.push_back({number_, own_.round, share, {}});
  if (share == Share::shown) close();
  return share;
}

void PartGatherer::end(bool traced, double now) {
  const State state = std::exchange(state_, State::idle);
  if (state == State::given) sendTo(to_, PartGone{});
  if (state == State::tracing && traced) {
    made_ = {number_, own_.round, {}, !given_.empty(), now, {}};
    for (const auto& [rank, part] : std::exchange(given_, {})) made_.ranks.push_back(rank);
  } else if (state == State::tracing) {
    decided_.pop_back();
  }
  giveBack();
  close(state == State::tracing && traced ? made_.ranks : std::vector<int>());
}

/// The peers' parts do not belong to an image of this rank.
void PartGatherer::giveBack() {
  for (const auto& [rank, part] : std::exchange(given_, {})) sendTo(rank, PartDone{{}, part.round});
}

/// This rank's part is for no image of peers any more. `with`: whose parts its own image shows.
void PartGatherer::close(const std::vector<int>& with) {
  if (std::exchange(isOpen_, false)) sendToAll(PartOver{{}, with});
}

/// The program does not show the image: the ranks whose parts it shows trace them.
void PartGatherer::giveUpMade() {
  if (!made_.shown.pixels.empty()) return void(made_.isOwed = false);
  const Made made = std::exchange(made_, {});
  for (const int rank : made.ranks) sendTo(rank, PartDone{{}, made.round});
}

void PartGatherer::atWork(double now) { made_.since = now; }

void PartGatherer::show(uint64_t number, const PartImage& image) {
  if (number != made_.number || made_.ranks.empty()) return;
  made_.isOwed = false;
  made_.shown = image;
  made_.shown.round = made_.round;
  for (const int rank : made_.ranks) sendTo(rank, made_.shown);
}

const PartImage* PartGatherer::image() {
  if (theirs_.number != number_ || theirs_.image.pixels.empty()) return nullptr;
  theirs_.isNew = false;
  return &theirs_.image;
}

void PartGatherer::joins(int rank) {
  meetings_.joins(rank);
  if (isOpen_) sendTo(rank, own_);  // what was sent before did not reach it
}

void PartGatherer::leaves(int rank, double now) {
  loses(rank, now);
  meetings_.leaves(rank);
  if (state_ == State::given && rank == to_) refused();
}

/// The peer may give another part soon.
void PartGatherer::loses(int rank, double now) {
  at(rank) = now;
  if (given_.erase(rank) > 0 && state_ == State::tracing) lost_ = true;
}

void PartGatherer::receive(const PartHere& part, double now) {
  const int rank = part.address.from;
  at(rank) = now;
  meetings_.opens(part);
  if (!isOpen_) return;
  if (!part.isAnswer) sendTo(rank, PartHere{{}, own_.round, true, own_.view});
  if (meetings_.stateOf(rank, now) != PartMeetings::State::here) return;
  if (state_ == State::tracing) lost_ = true;
  if (state_ == State::given && rank < to_) meetAgain();
}

void PartGatherer::receive(const PartOver& over, double now) {
  const int rank = over.address.from;
  meetings_.closes(rank);
  loses(rank, now);
  if (state_ != State::given || rank != to_) return;
  if (std::ranges::find(over.with, self_) != over.with.end()) return close();
  refused();
}

void PartGatherer::receive(const PartComes& comes, double now) {
  at(comes.address.from) = now;
  meetings_.comes(comes.address.from, now);
}

void PartGatherer::receive(PartGiven part, double now) {
  const int rank = part.address.from;
  at(rank) = now;
  const bool isWhole = state_ == State::meeting || state_ == State::collecting || state_ == State::tracing;
  if (isWhole && part.round == own_.round) {
    given_[rank] = std::move(part);
    lost_ = state_ == State::tracing;
    return;
  }
  // It may have asked for its image once more, after the whole was traced.
  const bool isMade = made_.round == part.round && std::ranges::find(made_.ranks, rank) != made_.ranks.end();
  if (isMade && !made_.shown.pixels.empty()) return sendTo(rank, made_.shown);
  if (!isMade || !made_.isOwed) sendTo(rank, PartDone{{}, part.round});
}

void PartGatherer::receive(const PartDone& done, double now) {
  at(done.address.from) = now;
  if (state_ != State::given || done.address.from != to_ || done.round != toRound_) return;
  refused();
}

/// The rank that has our part does not use it.
void PartGatherer::refused() {
  refusedBy_[to_] = toRound_;
  state_ = State::idle;  // nothing is to be taken back
  meetAgain();
}

void PartGatherer::receive(PartImage image, double now) {
  const int rank = image.address.from;
  at(rank) = now;
  const bool isAwaited = state_ == State::given && rank == to_ && image.round == toRound_;
  const PartImage& last = theirs_.image;
  const bool isBetter = !last.pixels.empty() && rank == last.address.from && image.round == last.round;
  if (!isAwaited && !isBetter) return;
  theirs_ = {isAwaited ? number_ : theirs_.number, true, std::move(image)};
  if (isAwaited) isShown_ = true;
}

void PartGatherer::receive(const PartGone& gone, double now) { loses(gone.address.from, now); }

void PartGatherer::receive(const PartAtWork& work, double now) { at(work.address.from) = now; }

void PartGatherer::comes(double now) {
  if (isOpen_ || !meetings_.someWait() || now - saidComes_ < Meetings::kSayEvery) return;
  saidComes_ = now;
  sendToAll(PartComes{});
}

void PartGatherer::tick(double now) {
  if (made_.isOwed && now - made_.since > kShowPatience) giveUpMade();
  const bool waits = state_ == State::idle || state_ == State::given || state_ == State::following;
  if ((waits && !made_.isOwed) || now - said_ < Meetings::kSayEvery) return;
  said_ = now;
  sendToAll(PartAtWork{});
}

}  // namespace gluray::cluster
