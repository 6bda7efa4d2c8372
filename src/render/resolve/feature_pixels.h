// Packs the auxiliary features of a pixel. Any thread.
#pragma once
#include <glm/glm.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace gluray::render {

/// Lower bound of the reflectance, because light is colour divided by reflectance.
constexpr float kMinReflectance = 1.0f / 64;

/// Three mantissas of 9 bits and a common exponent of 5, 2^-16 for 0.
inline uint32_t packReflectance(const glm::vec3& v) {
  constexpr float kMax = 32000;
  const auto inside = [&](float x) { return x > kMinReflectance ? std::min(x, kMax) : kMinReflectance; };
  const glm::vec3 color(inside(v.x), inside(v.y), inside(v.z));
  int exponent = 0;  // the largest is in [0.5, 1) * 2^exponent
  std::frexp(std::max({color.x, color.y, color.z}), &exponent);
  const float scale = std::ldexp(1.0f, 9 - exponent);
  uint32_t bits = static_cast<uint32_t>(exponent + 16) << 27;
  for (int c = 0; c < 3; ++c)
    bits |= std::clamp(static_cast<uint32_t>(color[c] * scale + 0.5f), 1u, 511u) << (9 * c);
  return bits;
}
inline glm::vec3 unpackReflectance(uint32_t bits) {
  const float scale = std::ldexp(1.0f, static_cast<int>(bits >> 27) - 16 - 9);
  return glm::vec3(bits & 511, bits >> 9 & 511, bits >> 18 & 511) * scale;
}

/// Two coordinates, -1 .. 1.
inline uint32_t packNormal2(const glm::vec2& v) {
  const auto code = [](float x) {
    return static_cast<uint32_t>(std::clamp(x, -1.0f, 1.0f) * 32767.0f + 32768.0f);
  };
  return code(v.x) | code(v.y) << 16;
}
inline glm::vec2 unpackNormal2(uint32_t bits) {
  const auto coordinate = [](uint32_t code) { return (static_cast<float>(code) - 32767.5f) / 32767.0f; };
  return {coordinate(bits & 65535), coordinate(bits >> 16)};
}

/// Keeps the leading 16 bits of a float.
inline uint16_t packFacing(float v) { return static_cast<uint16_t>(std::bit_cast<uint32_t>(v) >> 16); }
inline float unpackFacing(uint16_t code) { return std::bit_cast<float>(uint32_t{code} << 16 | 0x8000u); }

/// Rounds a float to its leading 16 bits.
inline uint16_t packCoverage(float v) {
  return static_cast<uint16_t>((std::bit_cast<uint32_t>(v) + 0x8000u) >> 16);
}
inline float unpackCoverage(uint16_t code) { return std::bit_cast<float>(uint32_t{code} << 16); }

}  // namespace gluray::render
