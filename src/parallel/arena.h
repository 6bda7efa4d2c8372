// Threads for parallel loops. The calling thread takes part in the work. Loops outside of an arena would run
// in TBB's own, which takes all cores and the signals of the program: none of ours does.
#pragma once
#include <tbb/task_arena.h>

#include <memory>
#include <utility>

namespace gluray {

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

/// The arena of `threads` threads (0: as many as the process may use) for all that is not a frame: meshes are
/// built in it, finished pictures put into windows. Frames have one of their own (frame/renderer.cpp), so
/// that nobody waits for them. Any thread.
std::shared_ptr<Arena> sharedArena(int threads);

/// The threads of sharedArena() for those who know no settings; 0 at first.
void setSharedThreads(int threads) noexcept;
std::shared_ptr<Arena> sharedArena();

}  // namespace gluray
