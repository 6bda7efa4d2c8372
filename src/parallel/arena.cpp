#include "parallel/arena.h"

#include "base/never_destroyed.h"

#include <tbb/info.h>
#include <tbb/task_scheduler_observer.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <mutex>

namespace gluray {

// Blocks signals on the workers: a host's signal handlers must not run on threads unknown to the host.
class Arena::Observer : public tbb::task_scheduler_observer {
 public:
  explicit Observer(tbb::task_arena& arena) : tbb::task_scheduler_observer(arena) { observe(true); }
  ~Observer() override { observe(false); }

  void on_scheduler_entry(bool isWorker) override {
    if (!isWorker) return;
    sigset_t blocked;
    sigfillset(&blocked);
    for (const int fault : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP}) sigdelset(&blocked, fault);
    pthread_sigmask(SIG_SETMASK, &blocked, nullptr);
  }
};

// At most one thread per core: more would not help, and TBB would warn on stderr.
Arena::Arena(int threads)
    : arena_(threads > 0 ? std::min(threads, tbb::info::default_concurrency()) : tbb::task_arena::automatic) {
  arena_.initialize();
  observer_ = std::make_unique<Observer>(arena_);
}

Arena::~Arena() = default;

namespace {

struct Owned {
  std::shared_ptr<Arena> arena;  // of the last call
  int threads = 0;               // of that arena
};
struct Arenas {
  std::mutex mutex;
  std::array<Owned, 2> byUse;
  std::atomic<int> usualThreads{0};
};
Arenas& arenas() {
  static NeverDestroyed<Arenas> all;
  return *all;
}

}  // namespace

std::shared_ptr<Arena> arenaFor(ArenaUse use, int threads) {
  Arenas& all = arenas();
  const std::lock_guard lock(all.mutex);
  Owned& owned = all.byUse.at(static_cast<size_t>(use));
  if (!owned.arena || owned.threads != threads) {
    owned.arena = std::make_shared<Arena>(threads);
    owned.threads = threads;
  }
  return owned.arena;
}

void setSharedThreads(int threads) noexcept { arenas().usualThreads = threads; }

std::shared_ptr<Arena> sharedArena() { return arenaFor(ArenaUse::other, arenas().usualThreads); }

}  // namespace gluray
