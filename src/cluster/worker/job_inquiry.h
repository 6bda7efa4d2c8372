// Questions about the job: a head asks all ranks for their facts and answers its program; each rank answers
// heads. The worker's main thread.
#pragma once
#include "cluster/ranks/ranks.h"
#include "cluster/worker/connected_program.h"

#include <cstdint>
#include <vector>

namespace gluray::cluster {

class JobInquiry {
 public:
  /// `threads`: with which this rank traces. `ranks` must outlive it.
  JobInquiry(Ranks& ranks, int threads) : ranks_(ranks), threads_(threads) {}

  /// Asks all ranks. The program gets JobFacts when all have answered, or after two seconds. An earlier
  /// question of the program is dropped.
  void ask(ConnectedProgram& program, double now);
  /// The program is gone.
  void forget(const ConnectedProgram& program);
  /// As the rank that is asked.
  void receive(int head, const FactsWanted& wanted);
  /// As the head. Throws Malformed.
  void receive(int rank, const FactsGiven& given);
  /// Ends questions that are overdue. Call ten times a second or more.
  void tick(double now);

 private:
  struct Question {
    ConnectedProgram* program = nullptr;
    uint64_t id = 0;
    double since = 0;
    JobFacts facts;
    bool isAnswered() const;
  };

  Ranks& ranks_;
  const int threads_;
  std::vector<Question> questions_;
  uint64_t lastId_ = 0;
};

}  // namespace gluray::cluster
