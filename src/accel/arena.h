// The worker threads that build and trace. One per Renderer; the calling thread takes part in the work.
#pragma once
#include <tbb/task_arena.h>

#include <memory>
#include <utility>

namespace gluray::accel {

/// A pool of `threads` threads, the caller included. Workers block every signal of the host program.
class Arena {
 public:
  /// `threads` 0: as many as the process may use.
  explicit Arena(int threads);
  ~Arena();
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;

  /// Runs `work` inside the arena and returns its result; parallel algorithms in it use the arena's threads.
  template <class Work>
  auto execute(Work&& work) {
    return arena_.execute(std::forward<Work>(work));
  }
  int threads() { return arena_.max_concurrency(); }

 private:
  class Observer;
  tbb::task_arena arena_;
  std::unique_ptr<Observer> observer_;
};

}  // namespace gluray::accel
