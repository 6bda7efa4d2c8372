// Writes snapshots for other processes. Arrays stand in them by name (arrays.h): whoever sends the message
// sends those first that the receiver lacks.
#pragma once
#include "cluster/stream/shared_arrays.h"
#include "scene/snapshot.h"

#include <cstddef>
#include <vector>

namespace gluray::cluster {

/// A message that SnapshotDecoder reads, and the arrays that it names, each once.
struct EncodedSnapshot {
  std::vector<std::byte> message;
  std::vector<ArraySource> arrays;
};

/// Remembers arrays from snapshot to snapshot. One thread.
class SnapshotEncoder {
 public:
  /// Throws std::bad_alloc.
  EncodedSnapshot encode(const scene::Snapshot& snapshot);

 private:
  ArrayNames names_;
  size_t namesAfterForgetting_ = 0;
};

}  // namespace gluray::cluster
