#include "cluster/gather/part_meetings.h"

#include "cluster/peers/meetings.h"
#include "scene/box_corner.h"
#include "scene/same_camera.h"

#include <algorithm>

namespace gluray::cluster {
namespace {

/// Seconds to wait for peers that will surely draw, and for those of which nobody knows.
constexpr double kPatience = Meetings::kPatience, kShortPatience = 0.25;
constexpr size_t kMaxViews = 64;
constexpr uint32_t kMaxPause = 64;  // changes of data
/// Meetings in a row after which a difference of the counts of frames is relied on.
constexpr int kSteady = 3;

std::optional<glm::dmat4> eyeFromEye(const PartView& to, const PartView& from) {
  return scene::eyeFromEye(scene::CameraMatrices{to.clipFromEye, to.eyeFromWorld},
                           scene::CameraMatrices{from.clipFromEye, from.eyeFromWorld});
}

bool hasBox(const PartView& view) { return glm::all(glm::lessThanEqual(view.lower, view.upper)); }

std::array<glm::dvec3, 8> cornersOf(const PartView& view, const glm::dmat4& m) {
  std::array<glm::dvec3, 8> corners;
  for (int i = 0; i < 8; ++i)
    corners[static_cast<size_t>(i)] = m * glm::dvec4(scene::boxCorner(view.lower, view.upper, i), 1);
  return corners;
}

/// Whether a box lies outside of the view, beyond one of its planes.
bool isOutside(const std::array<glm::dvec3, 8>& corners, const glm::dmat4& clipFromSpace) {
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      const auto isBeyond = [&](const glm::dvec3& corner) {
        const glm::dvec4 clip = clipFromSpace * glm::dvec4(corner, 1);
        return sign * clip[axis] > clip.w;
      };
      if (std::ranges::all_of(corners, isBeyond)) return true;
    }
  return false;
}

}  // namespace

void PartMeetings::joins(int rank) {
  at(rank) = {};
  at(rank).patience = kPatience;
  for (auto& [view, habits] : views_) habits[static_cast<size_t>(rank)] = {};
}

void PartMeetings::leaves(int rank) {
  at(rank) = {};
  at(rank).hasLeft = true;
}

void PartMeetings::opens(const PartHere& part) {
  Peer& peer = at(part.address.from);
  peer.part = part;
  peer.isOpen = peer.hasDrawn = true;
  peer.mayBeOld = false;
  if (hasBox(part.view) && isOutside(cornersOf(part.view, glm::dmat4(1)), part.view.clipFromEye))
    peer.drawsOutside = true;
}

std::vector<PartMeetings::Habit>& PartMeetings::habitsOf(uint64_t view) {
  const auto known = views_.find(view);
  if (known != views_.end()) return known->second;
  if (views_.size() >= kMaxViews) views_.clear();
  std::vector<Habit>& habits = views_[view];
  // Whoever has drawn nothing anywhere is not awaited in each new view.
  habits.resize(peers_.size());
  for (size_t rank = 0; rank < peers_.size(); ++rank)
    habits[rank].late = habits[rank].told = peers_[rank].hasBeenLate && !peers_[rank].hasDrawn;
  return habits;
}

void PartMeetings::begin(const Scene& own, double now) {
  own_ = own;
  began_ = now;
  habits_ = &habitsOf(own.view);
  for (int rank = 0; rank < ranks(); ++rank) {
    Peer& peer = at(rank);
    peer.patience = rank == self_ ? 0 : patienceFor(peer, habitOf(rank));
    peer.met = false;
    peer.mayBeOld = peer.isOpen;
    if (peer.mayBeOld) peer.patience = std::max(peer.patience, kShortPatience);
  }
}

double PartMeetings::patienceFor(const Peer& peer, Habit& habit) const {
  if (habit.data != Hash128{} && habit.data != own_->data) ++habit.changes;
  habit.data = own_->data;
  const std::optional<bool> inView = isInView(habit);
  if (peer.hasLeft || (peer.skipsOutside && inView == false)) return 0;
  const bool comesIntoView = inView == true && !habit.wasInView;
  if (!habit.late || comesIntoView || habit.changes >= habit.pause) return kPatience;
  return own_->moving ? 0 : kShortPatience;
}

std::optional<bool> PartMeetings::isInView(const Habit& habit) const {
  if (!habit.box) return std::nullopt;
  return !isOutside(*habit.box, own_->part.view.clipFromEye * own_->part.view.eyeFromWorld);
}

bool PartMeetings::showsView(const Peer& peer) const {
  const PartView& view = peer.part.view;
  return own_ && peer.isOpen && !peer.mayBeOld && own_->part.view.viewport == view.viewport &&
         eyeFromEye(own_->part.view, view);
}

bool PartMeetings::hasOurEyeSpace(int rank) const {
  return eyeFromEye(own_->part.view, partOf(rank).view) == glm::dmat4(1);
}

bool PartMeetings::someWait() const { return std::ranges::any_of(peers_, &Peer::isOpen); }

PartMeetings::State PartMeetings::stateOf(int rank, double now) {
  Peer& peer = at(rank);
  if (rank == self_ || !own_) return State::absent;
  if (showsView(peer)) {
    const int64_t ahead = static_cast<int64_t>(peer.part.view.frame - own_->part.view.frame);
    if (peer.alike < kSteady || ahead == peer.ahead) return meet(rank);
    // The ranks of this program do not wait for each other, and the peer is at a later frame.
    if (ahead > peer.ahead) return peer.alike = 0, peer.patience = 0, State::absent;
  }
  if (peer.patience == 0) return State::absent;
  if (now - std::max(began_, peer.comesAt) <= peer.patience) return State::awaited;
  noticeLate(rank);
  return State::absent;
}

void PartMeetings::noticeLate(int rank) {
  Peer& peer = at(rank);
  Habit& habit = habitOf(rank);
  const std::optional<bool> inView = isInView(habit);
  habit.wasInView = inView == true;
  if (inView == false && !peer.drawsOutside) peer.skipsOutside = true;
  if (peer.patience == kPatience) habit.pause = std::min(2 * habit.pause, kMaxPause), habit.changes = 0;
  habit.late = peer.hasBeenLate = true;
  peer.patience = 0, peer.alike = 0;
}

/// The peer is here.
PartMeetings::State PartMeetings::meet(int rank) {
  Peer& peer = at(rank);
  Habit& habit = habitOf(rank);
  const PartView& view = peer.part.view;
  const int64_t ahead = static_cast<int64_t>(view.frame - own_->part.view.frame);
  if (!std::exchange(peer.met, true)) peer.alike = ahead == peer.ahead ? peer.alike + 1 : 1;
  peer.ahead = ahead;
  habit.late = habit.told = false;
  peer.patience = 0;
  habit.changes = 0, habit.pause = 1;
  if (peer.drawsOutside) peer.skipsOutside = false;
  if (hasBox(view))
    habit.box =
        cornersOf(view, glm::inverse(own_->part.view.eyeFromWorld) * *eyeFromEye(own_->part.view, view));
  return State::here;
}

bool PartMeetings::awaits(double now) {
  bool some = false;
  for (int rank = 0; rank < ranks(); ++rank) some |= stateOf(rank, now) == State::awaited;
  return some;
}

std::vector<int> PartMeetings::here(double now) {
  std::vector<int> here;
  for (int rank = 0; rank < ranks(); ++rank)
    if (stateOf(rank, now) == State::here) here.push_back(rank);
  return here;
}

std::vector<int> PartMeetings::newlyLate() {
  std::vector<int> late;
  for (int rank = 0; rank < ranks(); ++rank) {
    Habit& habit = habitOf(rank);
    if (rank != self_ && habit.late && !std::exchange(habit.told, true)) late.push_back(rank);
  }
  return late;
}

}  // namespace gluray::cluster
