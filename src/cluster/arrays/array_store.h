// A worker's arrays, for the snapshots of all programs. Any thread.
#pragma once
#include "cluster/stream/shared_arrays.h"

#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <unordered_map>
#include <vector>

namespace gluray::cluster {

class ArrayStore {
 public:
  /// Keeps the array until each head (a rank) has called forget() as often as put(). Calls for a head may
  /// come in any order, because a broadcast takes longer than a message.
  void put(int head, const Hash128& name, Array array);
  void forget(int head, const std::vector<Hash128>& names);
  /// Returns the array; null if it is unknown. A forgotten array is found while someone still owns it.
  Array find(const Hash128& name) const;
  /// Waits until find() finds all arrays, or `stop` returns true; checks `stop` after wake(). Returns whether
  /// all were found.
  bool waitFor(const std::vector<Hash128>& names, const std::function<bool()>& stop);
  void wake();
  size_t bytes() const;

 private:
  struct Kept {
    Array array;
    std::map<int, int> uses;  // by head: puts without forgets; never 0
  };
  /// Returns true if no head uses it any more.
  static bool change(Kept& kept, int head, int by);
  mutable std::mutex mutex_;
  std::condition_variable more_;
  std::unordered_map<Hash128, Kept> arrays_;
  struct Forgotten {
    std::weak_ptr<const void> owner;
    std::span<const std::byte> bytes;
  };
  void remember(const Hash128& name, const Array& array);
  Array findLocked(const Hash128& name) const;
  std::unordered_map<Hash128, Forgotten> forgotten_;
  size_t forgottenAtMost_ = 64;  // number of entries at which expired ones are removed
};

}  // namespace gluray::cluster
