// A rank of a job of workers: the loop of its main thread.
#pragma once
#include "cluster/arrays/array_intake.h"
#include "cluster/pages/page_maker.h"
#include "cluster/pages/page_store.h"
#include "cluster/ranks/ranks.h"
#include "cluster/worker/head.h"
#include "cluster/worker/job_inquiry.h"
#include "cluster/worker/member.h"
#include "cluster/worker/roll_call.h"
#include "control/descriptor.h"

#include <atomic>

namespace gluray::cluster {

class Worker {
 public:
  /// `threads`: that trace, 0: as many as the process may use. `listening`: a socket that programs connect
  /// to, not blocking; none: negative. `ranks` must outlive it. Throws std::system_error.
  /// `say`: any thread.
  /// `memory`: bytes that geometry and its structures may take; larger geometry comes in pages.
  Worker(Ranks& ranks, int threads, size_t memory, control::Descriptor listening, Head::Say say);

  /// Runs until all ranks have confirmed this version, so that programs may connect, or until `stop`. Throws
  /// RanksFailed.
  void meet(const std::atomic<bool>& stop);
  /// Runs until `stop`, which it checks ten times a second. Throws RanksFailed.
  void run(const std::atomic<bool>& stop);

 private:
  /// Handles messages that have arrived. Returns false if there were none.
  bool handleArrivals();
  void goOn();
  void handle(const RankMessage& message, double now);
  void accept();
  void wait();

  Ranks& ranks_;
  const int threads_;
  ArrayStore store_;
  Outbox outbox_;
  ArrayIntake intake_;
  PageStore pages_;
  PageMaker pageMaker_;
  PeerPrograms peers_;
  JobInquiry inquiry_;
  RollCall roll_;
  Head head_;
  Member member_;
  control::Descriptor listening_;
  Head::Say say_;
  double lastBusy_ = 0;
};

}  // namespace gluray::cluster
