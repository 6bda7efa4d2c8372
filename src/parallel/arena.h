// Thread pools for parallel loops; the calling thread takes part in the work. All our loops run in one of
// these. TBB's implicit arena would use all cores, and its workers would handle the program's signals.
#pragma once
#include "base/ample_stack.h"

#include <tbb/task_arena.h>

#include <cstdint>
#include <memory>

namespace gluray {

/// A pool of `threads` threads, the caller included. Workers block every signal of the host program.
class Arena {
 public:
  /// `threads` 0: as many as the process should use (base/processes/usable_cores.h).
  explicit Arena(int threads);
  ~Arena();
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;

  /// Runs `work` inside the arena and returns its result; parallel algorithms in it use the arena's threads.
  /// Where the caller's stack is short, a thread of ours takes the caller's part.
  template <class Work>
  auto execute(Work&& work) {
    return onAmpleStack([&] { return arena_.execute(work); });
  }
  int threads() { return arena_.max_concurrency(); }

 private:
  class Observer;
  tbb::task_arena arena_;
  std::unique_ptr<Observer> observer_;
};

/// Purpose of an arena. A thread that enters a fully used arena waits; frames have their own arena, so that
/// nothing else waits for a frame that is being traced.
enum class ArenaUse : uint8_t {
  frames,  // tracing, anti-aliasing, resolving
  other,   // building meshes, putting finished images into windows
};

/// The process's arena for that use, of `threads` threads (0: as many as the process should use). Made at the
/// first call, and again when the number changes. Any thread.
std::shared_ptr<Arena> arenaFor(ArenaUse use, int threads);

/// The number of threads for sharedArena(), the arena `other` for callers without settings; 0 at first.
void setSharedThreads(int threads) noexcept;
std::shared_ptr<Arena> sharedArena();

}  // namespace gluray
