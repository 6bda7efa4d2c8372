// Checks arrays of programs against their names (content hashes), on a thread of its own: many gigabytes take
// seconds, in which the worker's main thread must send signs of life. Called on the main thread.
#pragma once
#include "cluster/arrays/array_store.h"
#include "cluster/ranks/outbox.h"
#include "cluster/stream/shared_arrays.h"
#include "parallel/arena.h"

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

namespace gluray::cluster {

class ArrayIntake {
 public:
  /// Stores checked arrays in `store` for the head `self`, using up to `threads` threads, and sends
  /// ArrayChecked to that rank. All must outlive it.
  ArrayIntake(ArrayStore& store, Outbox& outbox, int self, int threads);
  /// Discards unchecked arrays.
  ~ArrayIntake();
  ArrayIntake(const ArrayIntake&) = delete;
  ArrayIntake& operator=(const ArrayIntake&) = delete;

  /// `number`: number of the check, for ArrayChecked.
  void add(uint64_t number, const Hash128& name, Array array);

 private:
  struct Check {
    uint64_t number = 0;
    Hash128 name;
    Array array;
  };
  void run();
  void check(Check& one);

  ArrayStore& store_;
  Outbox& outbox_;
  const int self_;
  Arena arena_;
  std::mutex mutex_;
  std::condition_variable more_;
  std::vector<Check> checks_;
  bool ends_ = false;
  std::thread thread_;
};

}  // namespace gluray::cluster
