// Guides of an image's pixels for denoising. Plain data.
#pragma once
#include "base/image.h"
#include "scene/light_sampling.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gluray::frame {

/// Packed (render/resolve/wavelet.h). Empty: no auxiliary features.
struct AuxiliaryFeatures {
  // per pixel: without and with coverage and spread; more of light without noise
  static constexpr size_t kBytes = 14, kMixedBytes = 18, kNoiselessBytes = 4;

  std::vector<uint32_t> reflectance, normal;
  std::vector<uint32_t> noiseless;  // as shown (LightSampling::Mode::noiseless); empty: black
  std::vector<uint16_t> facing;
  std::vector<float> distance;
  std::vector<uint16_t> coverage, spread;  // of pixels that mix samples or layers; otherwise empty
  uint32_t passes = 0;                     // that the features average
  bool backdrop = false;                   // what lies behind the surfaces has colours
  bool catcher = false;                    // the alpha of some pixels is noisy

  bool known() const { return passes > 0; }
  size_t bytes() const {
    return 4 * (reflectance.capacity() + normal.capacity() + noiseless.capacity() + distance.capacity()) +
           2 * (facing.capacity() + coverage.capacity() + spread.capacity());
  }
};

/// Adds a pass of the mode reflectance or geometry to the mean of `features.passes` earlier ones. `mixed`:
/// the pass has the values of mixed pixels (render/resolve/mixed_features.h). Throws std::bad_alloc.
void keepFeatures(scene::LightSampling::Mode mode, const Image& pass, bool mixed,
                  AuxiliaryFeatures& features);

/// The reflectance of images whose alpha is a fraction of light (scene::Snapshot::catches). Throws
/// std::bad_alloc.
void keepCatcher(size_t pixels, AuxiliaryFeatures& features);

}  // namespace gluray::frame
