// The mean of many passes over one snapshot whose samples of light differ, and an estimate of its noise. Used
// by one thread at a time.
#pragma once
#include "base/image.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace gluray::frame {

/// Running means of all passes, and of the first 1, 2, 4, 8 ... of them: in these the samples are well
/// distributed, and in the rest, too, once there are as many, so that their difference tells the noise of the
/// mean. The variance of single passes, or of even and odd ones, would be too large, because their samples
/// complete each other. A value that is equal in all passes is kept to the bit. Values that are not finite do
/// not count. The same passes give the same bits, whatever the number of threads.
class Refinement {
 public:
  /// Adds a pass with wide colours or bytes. All passes must have the same shape. Throws std::bad_alloc.
  void add(const Image& pass);
  uint32_t passes() const { return passes_; }
  /// Standard error of the mean that add() computed last: root mean square over the red, green and blue of
  /// all pixels that a ray hit, displayed values from 0 to 1. Infinite before the second pass.
  double noise() const { return noise_; }
  /// Writes the means into `out`: colours rounded as the kernels round them, with misses in out.missColor;
  /// floats if `wide`. All else is copied from `pass`.
  void show(const Image& pass, bool wide, Image& out) const;
  size_t bytes() const { return 4 * (mean_.capacity() + half_.capacity()); }
  /// Memory for the passes of so many pixels, an image with wide colours included.
  static size_t bytesFor(size_t pixels) { return 4 * pixels * (4 + 3 + 4 + 1); }

 private:
  std::vector<float> mean_;  // four a pixel
  std::vector<float> half_;  // three a pixel: the mean of the first halfPasses_
  uint32_t passes_ = 0, halfPasses_ = 0;
  double noise_ = std::numeric_limits<double>::infinity();
};

}  // namespace gluray::frame
