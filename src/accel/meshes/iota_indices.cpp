#include "accel/meshes/iota_indices.h"

#include <algorithm>
#include <numeric>

namespace gluray::accel {

std::shared_ptr<const uint32_t[]> IotaIndices::get(size_t count) {
  constexpr size_t kSmallest = 3 * 4096, kPadding = 4;
  const std::lock_guard lock(mutex_);
  if (count > count_) {
    const size_t wanted = std::max({count, kSmallest, count_ + count_ / 2});
    std::shared_ptr<uint32_t[]> longer(new uint32_t[wanted + kPadding]);
    std::iota(longer.get(), longer.get() + wanted + kPadding, 0u);
    indices_ = std::move(longer);
    count_ = wanted;
  }
  return indices_;
}

}  // namespace gluray::accel
