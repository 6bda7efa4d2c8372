// Checks that all ranks of a job have the same version, before programs may connect. The worker's main
// thread.
#pragma once
#include "cluster/ranks/ranks.h"

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace gluray::cluster {

class RollCall {
 public:
  /// Sends this rank's version to rank 0. Both must outlive it. `say`: one line for the user.
  RollCall(Ranks& ranks, std::string version, std::function<void(const std::string&)> say);

  /// As rank 0. Throws RanksFailed, with a line for the user, if that rank has another version.
  void takeHello(int from, std::span<const std::byte> body);
  /// From rank 0: all ranks have the same version.
  void takeEnd() { isOver_ = true; }
  bool isOver() const { return isOver_; }
  /// As rank 0: logs silent ranks once. Call at least ten times a second.
  void tick(double now);

 private:
  Ranks& ranks_;
  const std::string version_;
  const std::function<void(const std::string&)> say_;
  std::vector<bool> here_;  // by rank, as rank 0
  bool isOver_ = false, said_ = false;
  double since_ = 0;  // of the first tick
};

}  // namespace gluray::cluster
