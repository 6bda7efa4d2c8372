// Checks that arrays of programs are what their names say. It has a thread of its own: many gigabytes take
// seconds, in which the worker's main thread must say that it is at work. Its calls: the main thread.
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
  /// Puts arrays into `store` for the head `self`, with up to `threads` threads, and sends ArrayChecked to
  /// that rank. All must outlive it.
  ArrayIntake(ArrayStore& store, Outbox& outbox, int self, int threads);
  /// Drops what has not been checked.
  ~ArrayIntake();
  ArrayIntake(const ArrayIntake&) = delete;
  ArrayIntake& operator=(const ArrayIntake&) = delete;

  /// `number`: of the check, for ArrayChecked.
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
