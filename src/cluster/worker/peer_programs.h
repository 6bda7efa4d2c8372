// The ranks of sort-last programs that this worker serves: each has a tracing thread and an exchange with its
// peers. The worker's main thread.
#pragma once
#include "cluster/arrays/array_store.h"
#include "cluster/gather/part_gatherer.h"
#include "cluster/messages/figure_messages.h"
#include "cluster/messages/peer_messages.h"
#include "cluster/messages/program_messages.h"
#include "cluster/messages/rank_messages.h"
#include "cluster/peers/peer_directory.h"
#include "cluster/peers/peer_exchange.h"
#include "cluster/ranks/outbox.h"
#include "cluster/ranks/ranks.h"
#include "cluster/worker/tracing_thread.h"

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>

namespace gluray::cluster {

class PeerPrograms {
 public:
  using Say = PeerExchange::Say;  // any thread

  /// `threads`: tracing threads for each program. All must outlive it.
  PeerPrograms(Ranks& ranks, ArrayStore& store, Outbox& outbox, int threads, Say say);
  ~PeerPrograms();
  PeerPrograms(const PeerPrograms&) = delete;
  PeerPrograms& operator=(const PeerPrograms&) = delete;

  /// Rank `rank` of `ranks` of the program that `program` names. Returns its number.
  uint64_t add(const Hash128& program, int rank, int ranks);
  void remove(uint64_t number);
  void trace(uint64_t number, TraceOrder order, const ViewName& shown);
  /// Ends tracing of the image.
  void end(uint64_t number, uint64_t image);
  /// The image of that rank, requested so many seconds ago, is with its program.
  void took(uint64_t number, double seconds);
  /// The program of that rank ends by itself.
  void ends(uint64_t number);
  /// What FiguresKnown says to the program of that rank.
  FiguresKnown figuresFor(uint64_t number);
  /// The gatherer of that rank.
  PartGatherer& gatherer(uint64_t number) { return *locals_.at(number).gatherer; }
  /// Handles a message of rank `from` of the job. Returns false if it is for another receiver. Throws
  /// Malformed.
  bool receive(int from, uint16_t type, std::span<const std::byte> body, double now);
  void tick(double now);
  bool isBusy() const;

 private:
  struct Local {
    Hash128 program;
    int rank = 0, ranks = 1;
    std::unique_ptr<PeerExchange> exchange;
    std::unique_ptr<PartGatherer> gatherer;
    std::unique_ptr<TracingThread> thread;
    uint64_t image = 0;  // that is traced; 0: none
    std::shared_ptr<TileQueue> tiles;
    RankFigures figures;
    std::atomic<uint64_t> bytesSent{0};
    std::map<int, RankFigures> known;  // figures of the program's ranks, at its rank 0
  };
  void measure(Local& local);
  void giveFigures(Local& local);
  void takeFigures(const FiguresGiven& given);
  static void take(Local& local, const RankFigures& figures);
  static void setState(Local& local, int rank, RankFigures::State state);
  Local* find(const PeerAddress& address);
  void joins(int from, const PeerAddress& address);
  void leaves(int from, const PeerAddress& address, double now);
  void tellAll(const Local& local, bool here);

  Ranks& ranks_;
  ArrayStore& store_;
  Outbox& outbox_;
  const int threads_;
  const Say say_;
  PeerDirectory directory_;
  std::map<uint64_t, Local> locals_;
  uint64_t last_ = 0;
};

}  // namespace gluray::cluster
