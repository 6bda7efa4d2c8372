#include "bench/data/wavelet.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace gluray::bench {

Volume wavelet(int halfExtent) {
  Volume out;
  const int count = 2 * halfExtent + 1;
  out.size = {count, count, count};
  out.origin = {float(-halfExtent), float(-halfExtent), float(-halfExtent)};
  out.values.resize(size_t(count) * size_t(count) * size_t(count));
  const double scale = 1.0 / (2.0 * halfExtent);
  tbb::parallel_for(0, count, [&](int k) {
    // The sines take the negated coordinate: the field was defined by the distance towards its centre.
    const double z = -(k - halfExtent) * scale;
    const double zPart = 5 * std::cos(40 * z);
    for (int j = 0; j < count; ++j) {
      const double y = -(j - halfExtent) * scale;
      const double yPart = 18 * std::sin(30 * y);
      float* row = out.values.data() + out.rowIndex(j, k);
      for (int i = 0; i < count; ++i) {
        const double x = -(i - halfExtent) * scale;
        const double bump = 255 * std::exp(-(x * x + y * y + z * z) / (2 * 0.5 * 0.5));
        row[i] = float(bump + 10 * std::sin(60 * x) + yPart + zPart);
      }
    }
  });
  return out;
}

std::vector<float> evenIsovalues(float low, float high, int count) {
  std::vector<float> out;
  for (int i = 0; i < count; ++i) out.push_back(low + (float(i) + 0.5f) / float(count) * (high - low));
  return out;
}

int waveletSurfaces(double millionTriangles) {
  struct Known {
    double million;
    int surfaces;
  };
  constexpr Known kKnown[] = {{1, 3}, {4, 14}, {16, 55}, {64, 219}, {128, 438}, {256, 875}};
  for (const Known& known : kKnown)
    if (known.million == millionTriangles) return known.surfaces;
  constexpr double kMillionPerSurface = 0.2925;
  return std::max(1, int(std::lround(millionTriangles / kMillionPerSurface)));
}

}  // namespace gluray::bench
