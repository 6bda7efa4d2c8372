// Index array 0, 1, 2, ... shared by all meshes without indices. Used by Blas; any thread.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>

namespace gluray::accel {

/// One array for all triangle soups. A longer request replaces it; readers of the old array keep it alive.
class IotaIndices {
 public:
  /// At least `count` ascending indices, followed by 16 readable bytes. Throws std::bad_alloc.
  std::shared_ptr<const uint32_t[]> get(size_t count);

 private:
  std::mutex mutex_;
  std::shared_ptr<const uint32_t[]> indices_;
  size_t count_ = 0;
};

}  // namespace gluray::accel
