#include "gl/batch/snapshot_memory.h"

namespace gluray::gl {

// Keeps the larger of the two capacities. `used` is empty; `count`: the number of elements that it had.
template <class T>
void SnapshotMemory::Store<T>::takeMemory(std::vector<T>& used, size_t count) {
  if (used.capacity() > spare.capacity()) spare.swap(used);
  idle = count > spare.capacity() / 4 ? 0 : idle + 1;
  if (idle > kPatience) std::vector<T>().swap(spare), idle = 0;
}

std::shared_ptr<scene::Snapshot> SnapshotMemory::make() {
  const auto giveBack = [kept = kept_](scene::Snapshot* used) {
    const std::unique_ptr<scene::Snapshot> end(used);
    const size_t instances = used->instances.size(), shadings = used->shadings.size();
    used->instances.clear();  // releases the meshes at once, outside the lock
    used->shadings.clear();
    const std::lock_guard lock(kept->mutex);
    kept->instances.takeMemory(used->instances, instances);
    kept->shadings.takeMemory(used->shadings, shadings);
  };
  std::shared_ptr<scene::Snapshot> made(new scene::Snapshot, giveBack);
  const std::lock_guard lock(kept_->mutex);
  made->instances.swap(kept_->instances.spare);
  made->shadings.swap(kept_->shadings.spare);
  return made;
}

}  // namespace gluray::gl
