// A noisy image for tests of the wavelet filter.
#pragma once
#include "render/resolve/feature_pixels.h"
#include "render/resolve/wavelet.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace gluray::test {

/// An image of a wall that faces the viewer, white, of light 0.5 with a standard error of 0.1.
struct NoisyWall {
  int width, height;
  std::vector<float> color, reflectance, geometry, depth;
  std::vector<uint16_t> noise;
  std::vector<uint32_t> packedReflectance, normal;
  std::vector<uint16_t> facing, packedCoverage;  // packedCoverage: empty: no pixel is mixed
  std::vector<float> distance;
  std::vector<uint32_t> noiseless;  // empty: none
  float target = 0, most = std::numeric_limits<float>::max();

  explicit NoisyWall(int w = 80, int h = 70) : width(w), height(h) {
    const size_t n = static_cast<size_t>(w) * static_cast<size_t>(h);
    color.assign(4 * n, 0.5f), reflectance.assign(4 * n, 1), depth.assign(n, 0.5f);
    noise.assign(n, static_cast<uint16_t>(0.1f * render::kNoiseOne));
    for (size_t i = 0; i < n; ++i) geometry.insert(geometry.end(), {0, 0, -1000, 1});
  }
  size_t at(int x, int y) const { return static_cast<size_t>(y * width + x); }
  /// Calls set(x, y, pixel) for all pixels.
  template <class Set>
  void each(const Set& set) {
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) set(x, y, at(x, y));
  }
  void light(size_t pixel, float light) {
    for (size_t c = 0; c < 3; ++c) color[4 * pixel + c] = light * reflectance[4 * pixel + c];
  }
  render::NoisyImage image(bool knowsNoise) {
    const size_t n = depth.size();
    packedReflectance.resize(n), normal.resize(n), facing.resize(n), distance.resize(n);
    render::packReflectances(reflectance.data(), n, packedReflectance.data());
    render::packGeometry(geometry.data(), depth.data(), n, normal.data(), facing.data(), distance.data());
    return {width,
            height,
            color.data(),
            knowsNoise ? noise.data() : nullptr,
            {packedReflectance.data(), normal.data(), facing.data(), distance.data(),
             noiseless.empty() ? nullptr : noiseless.data(),
             packedCoverage.empty() ? nullptr : packedCoverage.data()},
            target,
            most};
  }
  /// The smoothed image's reds; `changed` tells whether any tile was smoothed.
  std::vector<float> smooth(bool knowsNoise = true, bool* changed = nullptr) {
    const render::NoisyImage in = image(knowsNoise);
    std::vector<float> memory(render::waveletFloats()),
        tile(4 * render::WaveletTile::kSize * render::WaveletTile::kSize), out;
    for (size_t i = 0; i < depth.size(); ++i) out.push_back(color[4 * i]);
    for (int y = 0; y < height; y += render::WaveletTile::kSize)
      for (int x = 0; x < width; x += render::WaveletTile::kSize) {
        const bool did = render::smoothTile(in, {x, y}, memory.data(), tile.data());
        if (changed) *changed |= did;
        for (int j = 0; did && j < render::WaveletTile::kSize && y + j < height; ++j)
          for (int i = 0; i < render::WaveletTile::kSize && x + i < width; ++i)
            out[at(x + i, y + j)] = tile[static_cast<size_t>(4 * (j * render::WaveletTile::kSize + i))];
      }
    return out;
  }
};

inline void addNoise(NoisyWall& wall) {
  std::mt19937 random(7);
  std::normal_distribution<float> normal(0.5f, 0.1f);
  wall.each([&](int, int, size_t i) { wall.light(i, normal(random)); });
}

}  // namespace gluray::test
