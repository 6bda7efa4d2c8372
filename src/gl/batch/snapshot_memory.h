// Reuses the memory of released snapshots. Instances of large scenes take megabytes, which the system would
// otherwise clear for every frame. Call make() on one thread; snapshots may be released on any thread.
#pragma once
#include "scene/snapshot.h"

#include <memory>
#include <mutex>
#include <vector>

namespace gluray::gl {

class SnapshotMemory {
 public:
  /// After this many consecutive snapshots that use at most a quarter of the memory, it is freed.
  static constexpr int kPatience = 64;

  /// Returns an empty snapshot, which may outlive this object.
  std::shared_ptr<scene::Snapshot> make();

 private:
  template <class T>
  struct Store {
    std::vector<T> spare;  // an empty vector that only keeps capacity
    int idle = 0;          // consecutive snapshots that hardly used it
    void takeMemory(std::vector<T>& used, size_t count);
  };
  struct Kept {
    std::mutex mutex;
    Store<scene::Instance> instances;
    Store<scene::Shading> shadings;
  };
  std::shared_ptr<Kept> kept_ = std::make_shared<Kept>();
};

}  // namespace gluray::gl
