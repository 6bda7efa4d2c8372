// Whether all ranks of a job are of one version, before programs may come: ranks of two versions would not
// understand each other. The worker's main thread.
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
  /// Says to rank 0 which version this rank is of. Both must outlive it. `say`: one line for the user.
  RollCall(Ranks& ranks, std::string version, std::function<void(const std::string&)> say);

  /// As rank 0. Throws RanksFailed, with a line for the user, where that rank is of another version.
  void takeHello(int from, std::span<const std::byte> body);
  /// From rank 0: all ranks are of one version.
  void takeEnd() { isOver_ = true; }
  bool isOver() const { return isOver_; }
  /// As rank 0: names ranks that have said nothing for long, once. Call ten times a second or more.
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
