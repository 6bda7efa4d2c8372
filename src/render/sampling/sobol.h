// Seeds of pixels, and the numbers of Sobol's sequence that all of them share. Any thread.
#pragma once
#include "render/local/group.h"

#include <bit>
#include <cstdint>

namespace gluray::render {

/// One seed for each lane: samples are a function of the pixel, the sample's index and the dimension,
/// whatever the number of threads.
struct PixelSeeds {
  alignas(64) uint32_t seed[kLanes];

  /// `x`, `y`: window positions.
  PixelSeeds(const float* x, const float* y) {
    for (int i = 0; i < kLanes; ++i) {
      const auto column = static_cast<uint32_t>(static_cast<int32_t>(x[i])),
                 row = static_cast<uint32_t>(static_cast<int32_t>(y[i]));
      seed[i] = column * 0x9e3779b1u ^ std::rotl(row * 0x85ebca77u, 13);
    }
  }
};

/// Who uses which two dimensions of a pixel's samples. Uses are independent of each other.
enum class Dimensions : uint32_t { ambientOcclusion = 1, lens = 40 };

/// The order in which a use takes the points of the sequence: every power of two of them from the beginning
/// is an aligned block of the sequence, which is stratified like its beginning.
constexpr uint32_t shuffled(uint32_t index, uint32_t use) {
  const auto reversed = [](uint32_t x) {
    uint32_t result = 0;
    for (int bit = 0; bit < 32; ++bit, x >>= 1) result = result << 1 | (x & 1);
    return result;
  };
  uint32_t x = reversed(index) + use * 0x9e3779b9u;
  x ^= x * 0x6c50b47cu, x ^= x * 0xb82f1e52u, x ^= x * 0xc7afe638u, x ^= x * 0x8d22f6e6u;
  return reversed(x);
}

/// The second dimension of Sobol's sequence, least significant digit first. The first dimension's is the
/// index.
constexpr uint32_t reversedSobol(uint32_t index) {
  // Column k of the generator matrix is row k of Pascal's triangle modulo 2.
  uint32_t result = 0, column = 1;
  for (; index; index >>= 1, column ^= column << 1)
    if (index & 1) result ^= column;
  return result;
}

}  // namespace gluray::render
