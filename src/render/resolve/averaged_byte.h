// Rounds colours to bytes. Any thread.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace gluray::render {

/// The nearest byte of an average from 0 to 255; halves are rounded up. Averages of up to 1024 bytes are
/// multiples of 1/1024 or more: a quarter of that absorbs the rounding of floats, so that the average and its
/// 255th part times 255 give equal bytes.
inline uint32_t averagedByte(float average) {
  constexpr float kRounding = 0x1p-12f;
  return static_cast<uint32_t>(std::clamp(average, 0.0f, 255.0f) + (0.5f + kRounding));
}

/// A displayed value, 0 .. 1, as the kernels round it; values that are no number are 0. `averages`: of
/// several samples.
inline uint32_t displayedByte(float v, bool averages) {
  const float bounded = v > 0 ? std::min(v, 1.0f) * 255 : 0;
  return averages ? averagedByte(bounded) : static_cast<uint32_t>(std::nearbyint(bounded));
}

}  // namespace gluray::render
