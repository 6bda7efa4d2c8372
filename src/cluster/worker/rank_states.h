// A head's view of the state of the ranks of its job. The worker's main thread.
#pragma once
#include "cluster/shares/tile_shares.h"

#include <algorithm>
#include <vector>

namespace gluray::cluster {

class RankStates {
 public:
  /// `threads`: of each, until it says how many it has.
  RankStates(int ranks, int self, int threads) : states_(static_cast<size_t>(ranks)), self_(self) {
    for (State& state : states_) state.threads = threads;
  }

  /// A result came from the rank, or it has caught up with the broadcasts.
  void heard(int rank, double now) {
    at(rank).heard = now, at(rank).isBack = true;
    tick(now);
  }
  /// Includes ranks that are back and whose rest is over.
  void tick(double now) {
    for (State& state : states_)
      if (state.late && state.isBack && now >= state.restsUntil) state.late = false, state.included = now;
  }
  /// A sign of life of the rank.
  void isThere(int rank, double now) { at(rank).heard = now; }
  /// Excludes the rank until it is heard, and where it was included a short time ago, for a rest that doubles
  /// each time: images that wait for a rank whose network is too slow take longer than without it. Returns
  /// the rest, in seconds.
  double setLate(int rank, double now) {
    State& state = at(rank);
    const bool again = state.included > 0 && now - state.included < kSoon;
    state.rest = again ? std::clamp(2 * state.rest, kFirstRest, kLongestRest) : 0;
    state.restsUntil = now + state.rest;
    state.late = true, state.isBack = false;
    return state.rest;
  }
  void setThreads(int rank, int threads) { at(rank).threads = threads; }
  /// A request was sent to a rank that had no open requests.
  void asked(int rank, double now) { at(rank).heard = now; }
  /// Whether a sign of the rank is overdue.
  bool isOverdue(int rank, double now) const {
    const State& state = states_[static_cast<size_t>(rank)];
    return rank != self_ && now - state.heard > kPatience;
  }
  bool isLate(int rank) const { return states_[static_cast<size_t>(rank)].late; }
  int self() const { return self_; }
  int size() const { return static_cast<int>(states_.size()); }
  int allThreads() const {
    int sum = 0;
    for (const State& state : states_) sum += state.threads;
    return sum;
  }
  /// Ranks for tracing an image; `alone`: only this rank.
  std::vector<Tracer> tracers(bool alone) const {
    std::vector<Tracer> all;
    for (int rank = 0; rank < size(); ++rank) {
      const State& state = states_[static_cast<size_t>(rank)];
      all.push_back({state.threads, 1, alone ? rank == self_ : !state.late});
    }
    return all;
  }

 private:
  // Seconds. Ranks that work on an image say so more often than kPatience.
  static constexpr double kPatience = 1, kSoon = 10, kFirstRest = 2, kLongestRest = 32;
  struct State {
    int threads = 1;
    double heard = 0;
    bool late = false, isBack = false;
    double rest = 0, restsUntil = 0;  // since it was late last
    double included = 0;              // again, after it was late; 0: never late
  };
  State& at(int rank) { return states_[static_cast<size_t>(rank)]; }

  std::vector<State> states_;
  int self_;
};

}  // namespace gluray::cluster
