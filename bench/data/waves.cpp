#include "bench/data/waves.h"

#include <algorithm>
#include <cmath>

namespace gluray::bench {

double evenly(uint64_t seed, uint64_t index) {
  uint64_t z = seed * 0xd1342543de82ef95u + (index + 1) * 0x9e3779b97f4a7c15u;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
  z = (z ^ z >> 27) * 0x94d049bb133111ebu;
  return double((z ^ z >> 31) >> 11) * 0x1p-53;
}

std::array<double, 3> directionOf(uint64_t seed, uint64_t index) {
  const double height = 2 * evenly(seed, 2 * index) - 1;
  const double angle = 2 * M_PI * evenly(seed, 2 * index + 1);
  const double flat = std::sqrt(1 - height * height);
  return {flat * std::cos(angle), height, flat * std::sin(angle)};
}

double Wave::at(const std::array<double, 3>& x) const {
  return amplitude * std::cos(k[0] * x[0] + k[1] * x[1] + k[2] * x[2] + phase);
}

std::vector<Wave> waves(int count, double lowest, double highest, double slope, uint64_t seed) {
  std::vector<Wave> out(static_cast<size_t>(count));
  double squares = 0;
  for (size_t i = 0; i < out.size(); ++i) {
    const double step = count > 1 ? double(i) / double(count - 1) : 0;
    const double length = lowest * std::pow(highest / lowest, step);
    const std::array<double, 3> direction = directionOf(seed, i);
    for (size_t axis = 0; axis < 3; ++axis) out[i].k[axis] = length * direction[axis];
    out[i].amplitude = std::pow(length, -slope);
    out[i].phase = 2 * M_PI * evenly(seed + 1, i);
    squares += out[i].amplitude * out[i].amplitude;
  }
  for (Wave& wave : out) wave.amplitude *= std::sqrt(2 / squares);
  return out;
}

WaveRows::WaveRows(const std::vector<Wave>& waves, const std::array<int, 3>& size,
                   const std::array<float, 3>& origin, const std::array<float, 3>& spacing)
    : size_(size), count_(waves.size()) {
  for (size_t axis = 0; axis < 3; ++axis)
    for (const Wave& wave : waves)
      for (int i = 0; i < size[axis]; ++i) {
        const double place = double(origin[axis]) + double(spacing[axis]) * i;
        const double angle = wave.k[axis] * place + (axis == 0 ? wave.phase : 0);
        const double scale = axis == 0 ? wave.amplitude : 1;
        axes_[axis].cosine.push_back(float(scale * std::cos(angle)));
        axes_[axis].sine.push_back(float(scale * std::sin(angle)));
      }
}

void WaveRows::row(int y, int z, std::vector<float>& out) const {
  const auto places = static_cast<size_t>(size_[0]);
  out.assign(places, 0.0f);
  for (size_t wave = 0; wave < count_; ++wave) {
    const size_t j = size_t(y) + size_t(size_[1]) * wave, k = size_t(z) + size_t(size_[2]) * wave;
    const float cy = axes_[1].cosine[j], sy = axes_[1].sine[j];
    const float cz = axes_[2].cosine[k], sz = axes_[2].sine[k];
    // The real part of a product of three numbers on the unit circle.
    const float c = cy * cz - sy * sz, s = cy * sz + sy * cz;
    const float* cx = axes_[0].cosine.data() + places * wave;
    const float* sx = axes_[0].sine.data() + places * wave;
    for (size_t i = 0; i < places; ++i) out[i] += c * cx[i] - s * sx[i];
  }
}

}  // namespace gluray::bench
