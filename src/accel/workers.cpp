#include "accel/workers.h"

#include "accel/arena.h"

#include <tbb/parallel_for.h>

#include <memory>
#include <mutex>

namespace gluray::accel {
namespace {

/// The arena of the last call, or one of as many threads as are wanted now.
std::shared_ptr<Arena> arenaOf(int threads) {
  struct Held {
    std::mutex mutex;
    std::shared_ptr<Arena> arena;
    int threads = 0;
  };
  static auto* held = new Held;  // never destroyed: hosts call us while they exit
  const std::lock_guard lock(held->mutex);
  if (!held->arena || held->threads != threads) {
    held->arena = std::make_shared<Arena>(threads);
    held->threads = threads;
  }
  return held->arena;
}

}  // namespace

void forEachPart(int threads, int count, const std::function<void(int)>& work) {
  const std::shared_ptr<Arena> arena = arenaOf(threads);
  arena->execute([&] { tbb::parallel_for(0, count, work); });
}

}  // namespace gluray::accel
