// The indices 0, 1, 2, ... that meshes without indices share. Used by Blas; one thread at a time.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>

namespace gluray::accel {

/// One array for all soups, replaced by a longer one when a longer one is asked for; who still reads the old
/// one keeps it.
class IotaIndices {
 public:
  /// At least `count` ascending indices, followed by 16 readable bytes. Throws std::bad_alloc.
  std::shared_ptr<const uint32_t[]> get(size_t count);

 private:
  std::shared_ptr<const uint32_t[]> indices_;
  size_t count_ = 0;
};

}  // namespace gluray::accel
