// The error of images that ranks have of their parts, composed by depth.
#pragma once
#include "base/image.h"

#include <cmath>
#include <list>

namespace gluray::bench {

/// Root of the mean square of the differences of red, 0 .. 255, over pixels that show surfaces.
inline double errorOf(const std::list<const Image*>& parts, const Image& truth) {
  double sum = 0, count = 0;
  for (size_t i = 0; i < truth.depth.size(); ++i) {
    if (truth.depth[i] == Image::kMiss) continue;
    const Image* front = parts.front();
    for (const Image* part : parts)
      if (part->depth[i] < front->depth[i]) front = part;
    const double d = static_cast<double>(front->color[i] & 255) - static_cast<double>(truth.color[i] & 255);
    sum += d * d, ++count;
  }
  return std::sqrt(sum / count);
}

}  // namespace gluray::bench
