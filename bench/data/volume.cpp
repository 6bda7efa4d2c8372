#include "bench/data/volume.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace gluray::bench {
namespace {

/// Volume of `size` whose line along `axis` through each grid point is `resample(line read, value at i)`.
/// Lines are independent, so slices across another axis run in parallel.
template <typename Resample>
Volume resampledAlong(const Volume& in, int axis, int newCount, const Resample& resample) {
  Volume out = in;
  out.size[axis] = newCount;
  out.values.resize(size_t(out.size[0]) * size_t(out.size[1]) * size_t(out.size[2]));
  const int last = in.size[axis] - 1;
  tbb::parallel_for(0, out.size[2], [&](int z) {
    for (int y = 0; y < out.size[1]; ++y) {
      float* row = out.values.data() + out.rowIndex(y, z);
      for (int x = 0; x < out.size[0]; ++x) {
        const std::array<int, 3> point{x, y, z};
        const auto sample = [&](int i) {
          std::array<int, 3> p = point;
          p[axis] = std::clamp(i, 0, last);
          return in.at(p[0], p[1], p[2]);
        };
        row[x] = resample(sample, point[axis]);
      }
    }
  });
  return out;
}

}  // namespace

std::pair<float, float> Volume::range() const {
  if (values.empty()) return {0, 0};
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return {*low, *high};
}

Volume refined(const Volume& volume, int factor) {
  Volume out = volume;
  if (factor <= 1) return out;
  for (int axis = 0; axis < 3; ++axis) {
    const int count = factor * (out.size[axis] - 1) + 1;
    out = resampledAlong(out, axis, count, [factor](const auto& sample, int i) {
      const int base = i / factor;
      const float t = float(i % factor) / float(factor);
      if (t == 0) return sample(base);
      const float a = sample(base - 1), b = sample(base), c = sample(base + 1), d = sample(base + 2);
      return b + 0.5f * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
    });
    out.spacing[axis] = volume.spacing[axis] / float(factor);
  }
  return out;
}

Volume smoothed(const Volume& volume, int passes) {
  Volume out = volume;
  for (int pass = 0; pass < passes; ++pass)
    for (int axis = 0; axis < 3; ++axis)
      out = resampledAlong(out, axis, out.size[axis], [](const auto& sample, int i) {
        return 0.25f * (sample(i - 1) + 2 * sample(i) + sample(i + 1));
      });
  return out;
}

}  // namespace gluray::bench
