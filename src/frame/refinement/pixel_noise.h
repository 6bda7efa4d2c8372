// Averages noise estimates over neighbours, because estimates of single pixels are inaccurate. Any thread.
#pragma once
#include "base/image.h"
#include "render/resolve/wavelet.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace gluray::frame {

/// Root mean square over those of the 3 x 3 pixels around (x, y) that have a hit. `noise` is that of the
/// image's pixels (Refinement::pixelNoise); `first`: the index of the plane's first pixel.
inline float noiseAbout(const std::vector<uint16_t>& noise, const Image& image, size_t first, int x, int y) {
  double sum = 0;
  int count = 0;
  for (int row = std::max(y - 1, 0); row <= std::min(y + 1, image.height - 1); ++row)
    for (int column = std::max(x - 1, 0); column <= std::min(x + 1, image.width - 1); ++column) {
      const size_t i =
          first + static_cast<size_t>(row) * static_cast<size_t>(image.width) + static_cast<size_t>(column);
      if (image.depth[i] == Image::kMiss) continue;
      const double error = noise[i] / double{render::kNoiseOne};
      sum += error * error, ++count;
    }
  return static_cast<float>(std::sqrt(sum / std::max(count, 1)));
}

}  // namespace gluray::frame
