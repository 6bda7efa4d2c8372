// Maps the ranks of sort-last programs to workers. Any thread.
#pragma once
#include "base/hash.h"

#include <map>
#include <mutex>
#include <optional>
#include <unordered_map>

namespace gluray::cluster {

class PeerDirectory {
 public:
  /// Returns true if the entry is new.
  bool add(const Hash128& program, int rank, int worker) {
    const std::lock_guard lock(mutex_);
    int& known = workers_[program].try_emplace(rank, -1).first->second;
    const bool isNew = known != worker;
    known = worker;
    return isNew;
  }
  void remove(const Hash128& program, int rank) {
    const std::lock_guard lock(mutex_);
    const auto found = workers_.find(program);
    if (found == workers_.end()) return;
    found->second.erase(rank);
    if (found->second.empty()) workers_.erase(found);
  }
  std::optional<int> workerOf(const Hash128& program, int rank) const {
    const std::lock_guard lock(mutex_);
    const auto found = workers_.find(program);
    if (found == workers_.end()) return std::nullopt;
    const auto at = found->second.find(rank);
    return at == found->second.end() ? std::nullopt : std::optional(at->second);
  }

 private:
  mutable std::mutex mutex_;
  std::unordered_map<Hash128, std::map<int, int>> workers_;
};

}  // namespace gluray::cluster
