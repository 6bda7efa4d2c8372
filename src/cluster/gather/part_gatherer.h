// Gathers the parts of a view from the ranks of a sort-last program, for one of these ranks. The rank either
// gathers the parts of the others and sends them the image that its program shows, or sends its part to the
// gathering rank and receives that image, or traces only its own part. The decision for a snapshot holds
// for all its passes. The worker's main thread.
#pragma once
#include "cluster/gather/part_meetings.h"
#include "cluster/messages/part_messages.h"
#include "cluster/messages/program_messages.h"
#include "cluster/peers/meetings.h"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gluray::cluster {

class PartGatherer {
 public:
  /// Sends to a peer.
  using Send = std::function<void(int peer, std::vector<std::byte> message)>;
  using Say = std::function<void(const std::string&)>;

  /// `self`: this rank, of the program's `ranks`. `say`: one line for the user.
  PartGatherer(const Hash128& program, int self, int ranks, Send send, Say say);

  /// The program requests an image whose parts are to be gathered, or that blends.
  void begin(const TraceRequest& request, double now);
  enum class Share : uint8_t {
    awaited,  // undecided
    whole,    // this rank traces all parts()
    shown,    // another rank has made image()
    own,      // this rank traces only its own part
  };
  /// Decides the rank's share of the view's image. `request`: that of begin().
  Share findShare(const TraceRequest& request, double now);
  /// Parts of other ranks, for Share::whole.
  const std::vector<PartGiven>& parts() const { return decided_[current_].parts; }
  /// Reason why the last part was not gathered; empty: no lasting reason.
  const std::string& whyOwn() const { return saidWhy_; }
  /// For Share::shown; null if it is no longer stored.
  const PartImage* image();
  /// Whether a part of the image has disappeared or arrived late: then the image must end, and
  /// findShare() decides again.
  bool isLost() const { return state_ == State::tracing && lost_; }
  /// Ends tracing of all parts; `traced`: it succeeded.
  void end(bool traced, double now);
  /// The program is sending geometry.
  void comes(double now);
  /// Work on an image of the program continues.
  void atWork(double now);
  /// The program shows the image of a snapshot whose parts this rank traced: sends it to the ranks of the
  /// parts.
  void show(uint64_t number, const PartImage& image);

  void joins(int rank);
  void leaves(int rank, double now);
  void receive(const PartHere& part, double now);
  void receive(const PartOver& over, double now);
  void receive(const PartComes& comes, double now);
  void receive(PartGiven part, double now);
  void receive(const PartDone& done, double now);
  void receive(PartImage image, double now);
  void receive(const PartGone& gone, double now);
  void receive(const PartAtWork& work, double now);
  /// Sends signs of life to peers. Call at least ten times a second.
  void tick(double now);

 private:
  enum class State : uint8_t {
    idle,
    meeting,     // finds the ranks with a part of the view
    collecting,  // waits for parts
    given,       // waits for PartDone or PartImage
    following,   // waits for another image of a part that was given
    tracing,     // Share::whole has been returned
  };
  struct Decided {
    uint64_t number = 0;  // of the snapshot
    uint64_t round = 0;   // of this rank
    Share share = Share::own;
    std::vector<PartGiven> parts;
  };
  /// The last gathered image that this rank made.
  struct Made {
    uint64_t number = 0, round = 0;  // of the snapshot; of this rank
    std::vector<int> ranks;          // that sent parts
    bool isOwed = false;             // the program has not shown it yet, or more passes follow
    double since = 0;                // time of the program's last request for it
    PartImage shown;                 // without pixels: never shown
  };
  /// The last image of another rank with this rank's part.
  struct Theirs {
    uint64_t number = 0;  // of the snapshot
    bool isNew = false;   // image() has not returned it
    PartImage image;
  };
  template <class M>
  void sendTo(int peer, M message) const {
    message.address = {program_, self_, peer};
    send_(peer, forRanks(message));
  }
  template <class M>
  void sendToAll(const M& message) const {
    for (int rank = 0; rank < meetings_.ranks(); ++rank)
      if (rank != self_) sendTo(rank, message);
  }
  std::vector<int> peersHere(double now);
  std::string whyNot(const std::vector<int>& peers) const;
  Share meet(const TraceRequest& request, double now);
  Share collect(const TraceRequest& request, double now);
  Share decide(Share share);
  void meetAgain();
  void giveBack();
  void close(const std::vector<int>& with = {});
  void refused();
  void giveUpMade();
  void loses(int rank, double now);
  bool isSilent(int rank, double now) const { return now - at(rank) > Meetings::kPatience; }
  double& at(int rank) { return heard_[static_cast<size_t>(rank)]; }
  double at(int rank) const { return heard_[static_cast<size_t>(rank)]; }

  const Hash128 program_;
  const int self_;
  const Send send_;
  const Say say_;
  PartMeetings meetings_;
  std::vector<double> heard_;  // time of each peer's last message
  State state_ = State::idle;
  PartHere own_;                       // of the current image; its round rises with each
  bool isOpen_ = false;                // announced to peers, and not closed yet
  uint64_t number_ = 0;                // of its snapshot
  std::map<int, PartGiven> given_;     // to this rank, for the current image
  std::map<int, uint64_t> refusedBy_;  // rounds of peers that refused the current part
  int to_ = -1;                        // the rank that has our part
  uint64_t toRound_ = 0;               // its round
  bool isShown_ = false;               // it has answered with the image
  Made made_;
  Theirs theirs_;
  bool lost_ = false;             // the gathered parts have changed
  std::vector<Decided> decided_;  // the last ones
  size_t current_ = 0;            // index into decided_, once it is decided
  double said_ = 0, saidComes_ = 0;
  std::string saidWhy_;
};

}  // namespace gluray::cluster
