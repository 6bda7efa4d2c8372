// The transfer functions of sRGB (IEC 61966-2-1), continued beyond 1. Pure functions; any thread.
#pragma once
#include <cmath>

namespace gluray::scene {

/// Linear light of a displayed value.
inline float decodedSrgb(float c) {
  return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
}
/// Displayed value of linear light.
inline float encodedSrgb(float c) {
  return c <= 0.0031308f ? c * 12.92f : 1.055f * std::pow(c, 1 / 2.4f) - 0.055f;
}

}  // namespace gluray::scene
