// Per-pixel seeds of scrambled Sobol sequences. Any thread.
#pragma once
#include "render/local/group.h"

#include <array>
#include <bit>
#include <cstdint>

namespace gluray::render {

/// One seed for each lane. Samples depend only on the pixel, the sample's index and the dimension, not on the
/// number of threads.
struct PixelSeeds {
  alignas(64) uint32_t seed[kLanes];
  // For pixels that share one sequence, so that neighbouring pixels have complementary samples: sample
  // `index` of all pixels of a block is one aligned block of the sequence.
  uint32_t sharing = 0;  // pixels of a block: 16 or 64; 0: each pixel has its own sequence
  bool turns = false;    // pixels take turns by turnedBlock()
  // Position of each lane among the points of a block, as the last digits of the index and of the second
  // dimension.
  alignas(64) uint32_t first[kLanes], second[kLanes];

  /// `x`, `y`: window positions.
  PixelSeeds(const float* x, const float* y) {
    for (int i = 0; i < kLanes; ++i) seed[i] = hashOf(columnOf(x[i]), columnOf(y[i]));
  }

  static uint32_t columnOf(float x) { return static_cast<uint32_t>(static_cast<int32_t>(x)); }
  static uint32_t hashOf(uint32_t column, uint32_t row) {
    return column * 0x9e3779b1u ^ std::rotl(row * 0x85ebca77u, 13);
  }
};

/// Seeds of pixels of which each 4x4 block shares a sequence of its own. `x`, `y`: window positions.
PixelSeeds blockSeeds(const float* x, const float* y);

/// Seeds of moving frames: all blocks of 4x4 pixels, or of 8x8, share one sequence.
/// `places`: lane in the 4x4 block (0 .. 15); of 64 pixels plus 16 times the number of that block (0 .. 3).
/// `turn`: permutes the points of a 4x4 block; in sixteen turns each pixel gets each point. Pixels 4k .. 4k +
/// 3 have one point in each quarter of the unit square.
PixelSeeds interleavedSeeds(uint32_t turn, uint32_t sharing, const uint32_t (&places)[kLanes]);

/// Assignment of pairs of sample dimensions to uses. Uses are independent of each other.
enum class Dimensions : uint32_t {
  ambientOcclusion = 1,
  shadows = 2,  // and the next three: one for each light that casts shadows
  lens = 40,
  path = 1024,            // and those after it: PathUse::count for each vertex of a path
  addedLights = 1 << 20,  // and those after it: one for each vertex of a path
};

/// Permutation of the sequence for a use: each initial run of a power of two points is an aligned block of
/// the sequence, which is stratified like the beginning of the sequence.
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

/// Block `index` of 16 points of the sequence for a use. A pixel of 4x4 takes the point at the result ^
/// PixelSeeds::first. So 16 pixels have all points of the block, and the points of each pixel are a
/// (0,2)-sequence of their own: digit k of the block's number turns the pixels by 3 * 2^k in the field of 16
/// elements modulo x^4 + x + 1, which a search over all turns found.
constexpr uint32_t turnedBlock(uint32_t index, uint32_t use) {
  // Digits of the block's number whose sum modulo 2 is digit 0, 1, 2, 3 of the turn.
  constexpr std::array<uint32_t, 4> kDigits = [] {
    std::array<uint32_t, 4> digits{};
    uint32_t turn = 3;
    for (uint32_t k = 0; k < 32; ++k, turn = turn & 8 ? turn << 1 ^ 19 : turn << 1)
      for (uint32_t d = 0; d < 4; ++d) digits[d] |= (turn >> d & 1) << k;
    return digits;
  }();
  const uint32_t block = shuffled(index, use);
  uint32_t turn = use * 0x9e3779b1u >> 28;  // uses pair the points of neighbouring pixels differently
  for (uint32_t d = 0; d < 4; ++d)
    turn ^= (static_cast<uint32_t>(std::popcount(block & kDigits[d])) & 1) << d;
  return block << 4 | turn;
}

inline PixelSeeds blockSeeds(const float* x, const float* y) {
  PixelSeeds seeds(x, y);
  seeds.sharing = 16, seeds.turns = true;
  for (int i = 0; i < kLanes; ++i) {
    const uint32_t column = PixelSeeds::columnOf(x[i]), row = PixelSeeds::columnOf(y[i]);
    seeds.seed[i] = PixelSeeds::hashOf(column >> 2, row >> 2);
    // The pixels of 2x2 have one point in each quarter of the unit square.
    seeds.first[i] = (column & 1) ^ (row & 1) * 3 ^ (column >> 1 & 1) * 4 ^ (row >> 1 & 1) * 12;
    seeds.second[i] = reversedSobol(seeds.first[i]);
  }
  return seeds;
}

inline PixelSeeds interleavedSeeds(uint32_t turn, uint32_t sharing, const uint32_t (&places)[kLanes]) {
  constexpr float kZeros[kLanes] = {};
  PixelSeeds seeds(kZeros, kZeros);
  seeds.sharing = sharing;
  const uint32_t flips = (turn & 1) << 3 | (turn & 2) << 1 | (turn & 4) >> 1 | (turn & 8) >> 3;
  for (uint32_t i = 0; i < kLanes; ++i) {
    const uint32_t pixel = places[i] & 15;
    seeds.first[i] = (pixel >> 2 | (pixel & 3) << 2 | (places[i] & ~15u)) ^ flips;
    seeds.second[i] = reversedSobol(seeds.first[i]);
  }
  return seeds;
}

}  // namespace gluray::render
