// Finds the peers with a part of this rank's current view. Ranks have different counts of views and scenes,
// because a rank draws nothing if its data lie outside of a view. But they composite each view before they
// continue with the next one: peers that wait at the same time, with the same camera and viewport, wait for
// the same image. The worker's main thread.
#pragma once
#include "cluster/messages/part_messages.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace gluray::cluster {

class PartMeetings {
 public:
  /// `self`: this rank, of the program's `ranks`.
  PartMeetings(int self, int ranks) : self_(self), peers_(static_cast<size_t>(ranks)) {}

  void joins(int rank);
  void leaves(int rank);
  /// The peer's program is sending geometry, so that a scene will follow.
  void comes(int rank, double now) { at(rank).comesAt = now; }
  /// The peer now waits for the image of this scene.
  void opens(const PartHere& part);
  /// The peer no longer waits.
  void closes(int rank) { at(rank).isOpen = false; }
  /// The peer has not answered: ignores it until it opens another scene.
  void fail(int rank) { closes(rank); }
  /// This rank's part of a view, for whose image it waits.
  struct Scene {
    PartHere part;
    uint64_t view = 0;    // equal for all scenes of one view of this rank's program
    Hash128 data;         // hash of the program's draws without the camera
    bool moving = false;  // a frame of an animation: does not wait for late parts
  };
  void begin(const Scene& own, double now);

  enum class State : uint8_t {
    awaited,
    here,    // waits for the image of its part of the same view
    absent,  // probably has no part of it
  };
  State stateOf(int rank, double now);
  /// Whether a peer is awaited.
  bool awaits(double now);
  /// Peers with a part, in order.
  std::vector<int> here(double now);
  /// Part of a peer that is here.
  const PartHere& partOf(int rank) const { return at(rank).part; }
  /// Whether the peer has this rank's eye space.
  bool hasOurEyeSpace(int rank) const;
  /// Whether any peer waits for an image.
  bool someWait() const;
  /// Peers that have become late since the last call.
  std::vector<int> newlyLate();
  int ranks() const { return static_cast<int>(peers_.size()); }

 private:
  using Corners = std::array<glm::dvec3, 8>;
  /// History of a peer in one view of this rank.
  struct Habit {
    std::optional<Corners> box;  // bounds of its last part, in this rank's world
    bool late = false;           // timed out, and has drawn nothing since
    bool told = false;           // newlyLate() has returned it
    bool wasInView = false;      // whether the box was in view at the timeout
    Hash128 data;                // of this rank, at the last begin()
    uint32_t changes = 0;        // of these data since it was last awaited
    uint32_t pause = 1;          // changes until a late peer is awaited again
  };
  struct Peer {
    PartHere part;  // the last one
    bool isOpen = false;
    double comesAt = -1e9;
    bool hasLeft = false;
    bool hasDrawn = false, hasBeenLate = false;
    bool drawsOutside = false;  // draws even if its data lie outside of the view
    bool skipsOutside = false;
    int64_t ahead = 0;    // its frame count minus ours
    int alike = 0;        // meetings in a row with that difference
    double patience = 0;  // seconds for which the current scene of this rank waits for it
    bool met = false;     // in that scene
    bool mayBeOld =
        false;  // it opened its scene before that one, which may be over, unless it says otherwise
  };
  Peer& at(int rank) { return peers_[static_cast<size_t>(rank)]; }
  const Peer& at(int rank) const { return peers_[static_cast<size_t>(rank)]; }
  Habit& habitOf(int rank) { return (*habits_)[static_cast<size_t>(rank)]; }
  std::vector<Habit>& habitsOf(uint64_t view);
  double patienceFor(const Peer& peer, Habit& habit) const;
  std::optional<bool> isInView(const Habit& habit) const;
  bool showsView(const Peer& peer) const;
  State meet(int rank);
  void noticeLate(int rank);

  const int self_;
  std::vector<Peer> peers_;
  std::map<uint64_t, std::vector<Habit>> views_;
  std::vector<Habit>* habits_ = nullptr;  // of the current view
  std::optional<Scene> own_;              // the current one
  double began_ = 0;
};

}  // namespace gluray::cluster
