// The head of the programs that are connected to this rank: receives their snapshots and arrays, distributes
// their images over the ranks, and returns the results. The worker's main thread.
#pragma once
#include "cluster/arrays/array_intake.h"
#include "cluster/arrays/array_store.h"
#include "cluster/pages/page_maker.h"
#include "cluster/ranks/ranks.h"
#include "cluster/worker/connected_program.h"
#include "cluster/worker/job_inquiry.h"
#include "cluster/worker/peer_programs.h"
#include "cluster/worker/rank_states.h"

#include <functional>
#include <list>
#include <string>
#include <unordered_map>
#include <vector>

namespace gluray::cluster {

class Head {
 public:
  /// One line for the user.
  using Say = std::function<void(const std::string&)>;

  /// `threads`: tracing threads of this rank. `memory`: maximum bytes of arrays and structures on each rank.
  /// All must outlive it.
  Head(Ranks& ranks, ArrayStore& store, ArrayIntake& intake, PageMaker& pages, PeerPrograms& peers,
       JobInquiry& inquiry, int threads, size_t memory, Say say);

  void add(control::Descriptor socket);
  /// Sockets to wait for.
  std::vector<int> descriptors();
  /// Reads messages of programs.
  void readPrograms(double now);
  void receive(const ArrayChecked& checked);
  void receive(const PagesMade& made, double now);
  void receive(int rank, const TracedTile& tile, double now);
  void receive(int rank, const CollectedTile& tile, double now);
  void receive(int rank, const Finished& result, double now);
  void receive(int rank, const Alive& alive, double now);
  void takeCaughtUp(int rank, double now) { states_.heard(rank, now); }
  /// Detects silent ranks, and sends signs of life to programs. Call at least ten times a second.
  void tick(double now);
  /// Whether an image is being traced.
  bool isBusy() const;
  size_t programs() const { return programs_.size(); }

 private:
  static constexpr int kCoordinator = 0;  // the rank that orders broadcasts
  struct Holders {
    int programs = 0;
    uint64_t bytes = 0;
    uint64_t check = 0;       // its number at the intake
    bool here = false;        // it has been checked
    bool shared = false;      // false for ranks of sort-last programs, whose arrays stay on this rank
    bool everywhere = false;  // all ranks of the job have it or will receive it
  };
  void handle(ConnectedProgram& program, const Message& message, double now);
  void greet(ConnectedProgram& program, const Hello& hello);
  void takeArray(ConnectedProgram& program, const ArrayComes& array, const control::Descriptor& memory);
  void spread(const Hash128& name, Holders& holders);
  /// Sends the program's arrays to all ranks from now on.
  void spreadAll(ConnectedProgram& program);
  void forget(ConnectedProgram& program, const std::vector<Hash128>& names);
  void ask(ConnectedProgram& program, double now);
  /// Starts the image, after the snapshot has been divided into pages if necessary.
  void askNow(ConnectedProgram& program, double now);
  /// Whether the program's geometry, with its structures, is larger than the memory of a rank.
  bool isLarge(const ConnectedProgram& program) const;
  bool needsPages(const ConnectedProgram& program) const;
  void makePages(ConnectedProgram& program, double now);
  void endPages(ConnectedProgram& program);
  /// Sends only these arrays of the program to all ranks.
  void spreadOnly(ConnectedProgram& program, const std::vector<Hash128>& names);
  /// Starts the image once this rank's share is decided.
  void gather(ConnectedProgram& program, double now);
  void start(ConnectedProgram& program, bool averages, double now);
  void start(ConnectedProgram& program, RequestedImage::Kind kind, bool averages, double now);
  TraceOrder orderOf(ConnectedProgram& program, bool averages);
  RequestedImage::Kind kindOf(const ConnectedProgram& program) const;
  static MovingOrder movingOrderOf(ConnectedProgram& program);
  /// Assigns further tiles after tiles have arrived or ranks were lost.
  void goOn(ConnectedProgram& program, double now);
  /// Sends the visibility buffer of a moving image after all tiles were collected, so that ranks colour their
  /// tiles.
  void giveVisibility(ConnectedProgram& program, double now);
  void broadcastVisibility(ConnectedProgram& program, const Array& visibility);
  void forgetVisibility(ConnectedProgram& program);
  /// Traces the image again on this rank only.
  void traceAlone(ConnectedProgram& program, double now);
  void giveTiles(ConnectedProgram& program);
  void giveTiles(RequestedImage& image, int rank);
  void end(ConnectedProgram& program);
  void endImage(ConnectedProgram& program, double now);
  bool lacksParts(const ConnectedProgram& program) const;
  /// Sends the finished image to the program.
  void finish(ConnectedProgram& program, double now);
  /// Sends the program the image of another rank's program.
  void giveShown(ConnectedProgram& program);
  void takeShown(ConnectedProgram& program, const ImageShown& shown, const control::Descriptor& memory);
  void sayAtWork(ConnectedProgram& program, double now);
  void leaveOut(int rank, double now);
  void leave(ConnectedProgram& program, double now);
  ConnectedProgram* programOf(uint64_t image);

  Ranks& ranks_;
  ArrayStore& store_;
  ArrayIntake& intake_;
  PageMaker& pages_;
  PeerPrograms& peers_;
  JobInquiry& inquiry_;
  const size_t memory_;
  Say say_;
  RankStates states_;
  std::list<ConnectedProgram> programs_;
  std::unordered_map<Hash128, Holders> holders_;  // of each array
  uint64_t lastImage_ = 0, lastCheck_ = 0, lastPaging_ = 0;
};

}  // namespace gluray::cluster
