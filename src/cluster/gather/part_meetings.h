// Which peers draw a part of the view that this rank draws, in the scene that it waits for. Ranks count
// neither views nor scenes alike, because a rank draws nothing where its data lie outside of a view. But they
// compose each view before they go on to the next one: peers that wait at the same time, with the same camera
// and viewport, wait for the same picture. The worker's main thread.
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
  /// The peer's program sends geometry: a scene comes.
  void comes(int rank, double now) { at(rank).comesAt = now; }
  /// The peer waits for the picture of this scene, now.
  void opens(const PartHere& part);
  /// It does not any more.
  void closes(int rank) { at(rank).isOpen = false; }
  /// The peer has not answered: it is left out until it opens another scene.
  void fail(int rank) { closes(rank); }
  /// Of this rank, which waits for the picture of its part of a view.
  struct Scene {
    PartHere part;
    uint64_t view = 0;    // equal for all scenes of one view of this rank's program
    Hash128 data;         // changes with what the program draws, the camera excepted
    bool moving = false;  // a frame of an animation: better soon than with all parts
  };
  void begin(const Scene& own, double now);

  enum class State : uint8_t {
    awaited,
    here,    // waits for the picture of its part of the same view
    absent,  // draws nothing of it, as far as is known
  };
  State stateOf(int rank, double now);
  /// Whether some peer is awaited.
  bool awaits(double now);
  /// Peers with a part, in order.
  std::vector<int> here(double now);
  /// Of a peer that is here.
  const PartHere& partOf(int rank) const { return at(rank).part; }
  /// Whether it shows what this rank shows in this rank's eye space.
  bool hasOurEyeSpace(int rank) const;
  /// Whether some peer waits for a picture.
  bool someWait() const;
  /// Peers that have become late since the last call.
  std::vector<int> newlyLate();
  int ranks() const { return static_cast<int>(peers_.size()); }

 private:
  using Corners = std::array<glm::dvec3, 8>;
  /// What is known of a peer in one view of this rank.
  struct Habit {
    std::optional<Corners> box;  // of its last part that was met, in this rank's world
    bool late = false;           // was awaited in vain, and has drawn nothing since
    bool told = false;           // newlyLate() has returned it
    bool wasInView = false;      // the box, when it was found late
    Hash128 data;                // of this rank, at the last begin()
    uint32_t changes = 0;        // of these data since it was last awaited
    uint32_t pause = 1;          // changes until a late one is awaited again
  };
  struct Peer {
    PartHere part;  // the last one
    bool isOpen = false;
    double comesAt = -1e9;
    bool hasLeft = false;
    bool hasDrawn = false, hasBeenLate = false;
    bool drawsOutside = false;  // also where its data lie outside of the view
    bool skipsOutside = false;
    int64_t ahead = 0;    // its count of frames, less ours
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
