// Writes snapshots for other processes. Snapshots contain arrays by name: the sender first sends the arrays
// that the receiver lacks.
#pragma once
#include "cluster/stream/shared_arrays.h"
#include "scene/snapshot.h"

#include <cstddef>
#include <vector>

namespace gluray::cluster {

/// A message for SnapshotDecoder, and the arrays that it uses, each once.
struct EncodedSnapshot {
  std::vector<std::byte> message;
  std::vector<ArraySource> arrays;
};

/// Caches the names of arrays between snapshots. One thread.
class SnapshotEncoder {
 public:
  /// Throws std::bad_alloc.
  EncodedSnapshot encode(const scene::Snapshot& snapshot);

 private:
  ArrayNames names_;
  size_t namesAfterForgetting_ = 0;
};

}  // namespace gluray::cluster
