#include "accel/workers.h"

#include "parallel/arena.h"

#include <tbb/parallel_for.h>

namespace gluray::accel {

void forEachPart(int threads, int count, const std::function<void(int)>& work) {
  sharedArena(threads)->execute([&] { tbb::parallel_for(0, count, work); });
}

}  // namespace gluray::accel
