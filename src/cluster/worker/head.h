// A rank as the head of the programs that are connected to it: takes their snapshots and arrays, shares their
// pictures among the ranks, and gives them back. The worker's main thread.
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

  /// `threads`: with which this rank traces. `memory`: bytes that arrays and structures may take on each
  /// rank. All must outlive it.
  Head(Ranks& ranks, ArrayStore& store, ArrayIntake& intake, PageMaker& pages, PeerPrograms& peers,
       JobInquiry& inquiry, int threads, size_t memory, Say say);

  void add(control::Descriptor socket);
  /// Sockets to wait for.
  std::vector<int> descriptors();
  /// Reads what programs have sent.
  void readPrograms(double now);
  void receive(const ArrayChecked& checked);
  void receive(const PagesMade& made, double now);
  void receive(int rank, const TracedTile& tile, double now);
  void receive(int rank, const FilmTile& tile, double now);
  void receive(int rank, const Finished& result, double now);
  void receive(int rank, const Alive& alive, double now);
  void takeCaughtUp(int rank, double now) { states_.heard(rank, now); }
  /// Notices ranks that say nothing, says to programs that work goes on. Call ten times a second or more.
  void tick(double now);
  /// Whether some picture is at work.
  bool isBusy() const;
  size_t programs() const { return programs_.size(); }

 private:
  static constexpr int kCoordinator = 0;  // the rank that orders broadcasts
  struct Holders {
    int programs = 0;
    uint64_t bytes = 0;
    uint64_t check = 0;       // its number at the intake
    bool here = false;        // it has been checked
    bool shared = false;      // ranks of sort-last programs keep what is theirs, others' is for all
    bool everywhere = false;  // all ranks of the job have it, or get it
  };
  void handle(ConnectedProgram& program, const Message& message, double now);
  void greet(ConnectedProgram& program, const Hello& hello);
  void takeArray(ConnectedProgram& program, const ArrayComes& array, const control::Descriptor& memory);
  void spread(const Hash128& name, Holders& holders);
  /// Pictures of the program need its arrays on all ranks from now on.
  void spreadAll(ConnectedProgram& program);
  void forget(ConnectedProgram& program, const std::vector<Hash128>& names);
  void ask(ConnectedProgram& program, double now);
  /// The same, once the snapshot has pages if it needs them.
  void askNow(ConnectedProgram& program, double now);
  /// Whether the program's geometry, with its structures, is larger than the memory of a rank.
  bool isLarge(const ConnectedProgram& program) const;
  bool needsPages(const ConnectedProgram& program) const;
  void makePages(ConnectedProgram& program, double now);
  void endPages(ConnectedProgram& program);
  /// Of the program's arrays only these are for all ranks.
  void spreadOnly(ConnectedProgram& program, const std::vector<Hash128>& names);
  /// Starts the picture once the share that is this rank's is known.
  void gather(ConnectedProgram& program, double now);
  void start(ConnectedProgram& program, bool averages, double now);
  void start(ConnectedProgram& program, Picture::Kind kind, bool averages, double now);
  TraceOrder orderOf(ConnectedProgram& program, bool averages);
  Picture::Kind kindOf(const ConnectedProgram& program) const;
  static FilmOrder filmOrderOf(ConnectedProgram& program);
  /// Hands out what can be done once tiles have come, or their ranks are gone.
  void goOn(ConnectedProgram& program, double now);
  /// A moving picture has been collected: ranks colour its tiles.
  void giveFilm(ConnectedProgram& program, double now);
  void broadcastFilm(ConnectedProgram& program, const Array& film);
  void forgetFilm(ConnectedProgram& program);
  /// Traces the picture anew, by this rank alone.
  void traceAlone(ConnectedProgram& program, double now);
  void giveTiles(ConnectedProgram& program);
  void giveTiles(Picture& picture, int rank);
  void end(ConnectedProgram& program);
  void endPicture(ConnectedProgram& program, double now);
  bool lacksParts(const ConnectedProgram& program) const;
  /// Gives the program its picture, if that is done.
  void finish(ConnectedProgram& program, double now);
  /// Gives the program the picture that another rank's program shows.
  void giveShown(ConnectedProgram& program);
  void takeShown(ConnectedProgram& program, const PictureShown& shown, const control::Descriptor& memory);
  void sayAtWork(ConnectedProgram& program, double now);
  void leaveOut(int rank);
  void leave(ConnectedProgram& program, double now);
  ConnectedProgram* programOf(uint64_t picture);

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
  uint64_t lastPicture_ = 0, lastCheck_ = 0, lastPaging_ = 0;
};

}  // namespace gluray::cluster
