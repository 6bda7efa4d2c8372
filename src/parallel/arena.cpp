#include "parallel/arena.h"

#include "base/never_destroyed.h"
#include "base/processes/address_space.h"
#include "base/processes/usable_cores.h"

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

namespace {

/// At most one thread per core that the system grants: more would not help, and TBB would warn on stderr.
/// Fewer where limits of the process leave little address space, most of which the real OpenGL needs.
int threadsWithin(int threads) {
  const int all = tbb::info::default_concurrency(), cores = std::min(all, mostThreadsHere());
  const int wanted = std::min(threads > 0 ? threads : chosenThreadsHere(), cores);
  const unsigned long long left = glurayAddressSpaceLeft();
  if (left == ULLONG_MAX) return threads > 0 || wanted < all ? wanted : tbb::task_arena::automatic;
  const unsigned long long kept = glurayFrameReserve,
                           each = (unsigned long long){glurayThreadMegabytes} << 20;
  const unsigned long long more = left > kept ? (left - kept) / each : 0;
  return static_cast<int>(std::min<unsigned long long>(static_cast<unsigned>(wanted), more + 1));
}

}  // namespace

Arena::Arena(int threads) : arena_(threadsWithin(threads)) {
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
