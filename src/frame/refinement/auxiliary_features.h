// Guides of an image's pixels for denoising. Plain data.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gluray::frame {

/// Packed (render/resolve/wavelet.h). Empty: no auxiliary features.
struct AuxiliaryFeatures {
  static constexpr size_t kBytes = 14;  // bytes per pixel

  std::vector<uint32_t> reflectance, normal;
  std::vector<uint16_t> facing;
  std::vector<float> distance;

  bool known() const { return !distance.empty(); }
  size_t bytes() const {
    return 4 * (reflectance.capacity() + normal.capacity() + distance.capacity()) + 2 * facing.capacity();
  }
};

}  // namespace gluray::frame
