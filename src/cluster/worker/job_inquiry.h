// Queries about the job: a head requests the properties of all ranks and answers its program; each rank
// answers heads. The worker's main thread.
#pragma once
#include "cluster/ranks/ranks.h"
#include "cluster/worker/connected_program.h"

#include <cstdint>
#include <vector>

namespace gluray::cluster {

class JobInquiry {
 public:
  /// `threads`: tracing threads of this rank. `ranks` must outlive it.
  JobInquiry(Ranks& ranks, int threads) : ranks_(ranks), threads_(threads) {}

  /// Queries all ranks. Sends JobFacts to the program when all have answered, or after two seconds. Drops an
  /// earlier query of the program.
  void ask(ConnectedProgram& program, double now);
  /// The program is gone.
  void forget(const ConnectedProgram& program);
  /// Handles a query as a rank.
  void receive(int head, const FactsWanted& wanted);
  /// Handles an answer as the head. Throws Malformed.
  void receive(int rank, const FactsGiven& given);
  /// Ends overdue queries. Call at least ten times a second.
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
