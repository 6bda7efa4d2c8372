#include "parallel/arena.h"

#include <tbb/info.h>
#include <tbb/task_scheduler_observer.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <mutex>

namespace gluray {

// A host's signal handler must never run on a thread that the host knows nothing of.
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

// More threads than cores would only take turns, and TBB says so on stderr.
Arena::Arena(int threads)
    : arena_(threads > 0 ? std::min(threads, tbb::info::default_concurrency()) : tbb::task_arena::automatic) {
  arena_.initialize();
  observer_ = std::make_unique<Observer>(arena_);
}

Arena::~Arena() = default;

namespace {

struct Shared {
  std::mutex mutex;
  std::shared_ptr<Arena> arena;  // of the last call
  int threads = 0;               // of that arena
  std::atomic<int> usual{0};
};
Shared& shared() {
  static auto* one = new Shared;  // never destroyed: hosts call us while they exit
  return *one;
}

}  // namespace

std::shared_ptr<Arena> sharedArena(int threads) {
  Shared& s = shared();
  const std::lock_guard lock(s.mutex);
  if (!s.arena || s.threads != threads) {
    s.arena = std::make_shared<Arena>(threads);
    s.threads = threads;
  }
  return s.arena;
}

void setSharedThreads(int threads) noexcept { shared().usual = threads; }

std::shared_ptr<Arena> sharedArena() { return sharedArena(shared().usual); }

}  // namespace gluray
