// Memory of snapshots that nobody reads any more, for the next ones: the instances of large scenes take
// megabytes, which the system would otherwise clear for every frame. make() on one thread; snapshots may be
// given up on any.
#pragma once
#include "scene/snapshot.h"

#include <memory>
#include <mutex>
#include <vector>

namespace gluray::gl {

class SnapshotMemory {
 public:
  /// Snapshots in a row that hardly use what they are given, after which it is freed.
  static constexpr int kPatience = 64;

  /// An empty snapshot. It may outlive this object.
  std::shared_ptr<scene::Snapshot> make();

 private:
  template <class T>
  struct Store {
    std::vector<T> spare;  // empty
    int idle = 0;
    void take(std::vector<T>& used, size_t count);
  };
  struct Kept {
    std::mutex mutex;
    Store<scene::Instance> instances;
    Store<scene::Shading> shadings;
  };
  std::shared_ptr<Kept> kept_ = std::make_shared<Kept>();
};

}  // namespace gluray::gl
