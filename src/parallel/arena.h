// Threads for parallel loops. The calling thread takes part in the work. Loops outside of an arena would run
// in TBB's own, which takes all cores and the signals of the program: none of ours does.
#pragma once
#include <tbb/task_arena.h>

#include <cstdint>
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

/// What the threads of an arena do. Who enters an arena whose threads are all at work waits for one: so that
/// nobody waits for a frame that is traced, frames have an arena of their own.
enum class ArenaUse : uint8_t {
  frames,  // tracing and what follows of it: anti-aliasing, resolving
  other,   // meshes that are built, finished pictures that are put into windows
};

/// The process's arena for that use, of `threads` threads (0: as many as the process may use). Made at the
/// first call, and anew where the number changes. Any thread.
std::shared_ptr<Arena> arenaFor(ArenaUse use, int threads);

/// The threads of arenaFor(ArenaUse::other) for those who know no settings; 0 at first.
void setSharedThreads(int threads) noexcept;
std::shared_ptr<Arena> sharedArena();

}  // namespace gluray
