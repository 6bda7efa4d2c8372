// A rank as a tracer for the heads of the job, including itself. The worker's main thread.
#pragma once
#include "cluster/arrays/array_store.h"
#include "cluster/messages/rank_messages.h"
#include "cluster/ranks/outbox.h"
#include "cluster/ranks/ranks.h"
#include "cluster/shares/tile_queue.h"
#include "cluster/worker/tracing_thread.h"

#include <cstdint>
#include <map>
#include <memory>
#include <utility>

namespace gluray::cluster {

class Member {
 public:
  /// `threads`: tracing threads of this rank. All must outlive it.
  Member(Ranks& ranks, ArrayStore& store, Outbox& outbox, PageStore& pages, int threads);
  ~Member();
  Member(const Member&) = delete;
  Member& operator=(const Member&) = delete;

  void receive(int head, TraceOrder order, double now);
  void receive(int head, const MoreTiles& tiles);
  void receive(int head, VisibilityReady visibility);
  void receive(int head, const EndOfImage& end);
  void receive(int head, const Forget& forget);
  /// Handles a request as the rank that orders broadcasts.
  void receive(int root, const TurnWanted& wanted);
  void receive(const Turn& turn);
  /// Sends signs of life to the heads of its images. Call at least ten times a second.
  void tick(double now);
  bool isBusy() const { return !queues_.empty(); }

 private:
  using Key = std::pair<int, uint64_t>;  // head, image

  Ranks& ranks_;
  ArrayStore& store_;
  Outbox& outbox_;
  PageStore& pages_;
  const int threads_;
  TracingThread tracing_;
  std::map<Key, std::shared_ptr<TileQueue>> queues_;
  std::map<int, int> incoming_;  // by head: number of incomplete broadcasts
  double saidAlive_ = 0;
};

}  // namespace gluray::cluster
