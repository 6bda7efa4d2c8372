// Helpers of the generated stubs: conversions of vertex attributes (GL 2.1, table 2.9) and copies of arrays
// passed by pointer, for display lists. Included by generated code and its test.
#pragma once
#include "gl/capture/vertex_attribute_calls.h"
#include "gl/handlers.h"
#include "gl/lists/param_counts.h"
#include "gl/stub.h"
#include "gl/window/finished_read.h"
#include "intercept/stubs/orphan_gl.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>
#include <vector>

namespace gluray::intercept::stubs {

/// An integer mapped to [0, 1] (unsigned) or [-1, 1] (signed: (2c + 1) / (2^b - 1)).
template <class Integer>
constexpr float normalised(Integer c) {
  constexpr double steps = static_cast<double>(std::numeric_limits<std::make_unsigned_t<Integer>>::max());
  if constexpr (std::is_signed_v<Integer>)
    return static_cast<float>((2.0 * c + 1.0) / steps);
  else
    return static_cast<float>(c / steps);
}

/// IEEE 754 half to single precision.
inline float halfToFloat(uint16_t half) {
  const uint32_t sign = static_cast<uint32_t>(half & 0x8000u) << 16, exponent = (half >> 10) & 31u,
                 fraction = half & 1023u;
  if (exponent == 0) {
    const float magnitude = static_cast<float>(fraction) * 0x1p-24f;
    return sign ? -magnitude : magnitude;
  }
  const uint32_t bits = sign | (exponent == 31 ? 0x7f800000u : (exponent + 112) << 23) | (fraction << 13);
  float result;
  std::memcpy(&result, &bits, sizeof result);
  return result;
}

struct Packed {
  float x, y, z, w;
};

/// Unpacks a packed attribute. False if `type` is not one of the two packed types of GL 3.3, section 2.7.
inline bool unpack(GLenum type, bool normalise, GLuint value, Packed& v) {
  const auto field = [&](int shift, int bits) {
    const uint32_t raw = (value >> shift) & ((1u << bits) - 1u);
    const double steps = (1 << bits) - 1;
    if (type == GL_UNSIGNED_INT_2_10_10_10_REV) return static_cast<float>(normalise ? raw / steps : raw);
    const int c = static_cast<int>(raw << (32 - bits)) >> (32 - bits);
    return static_cast<float>(normalise ? (2.0 * c + 1.0) / steps : c);
  };
  if (type != GL_UNSIGNED_INT_2_10_10_10_REV && type != GL_INT_2_10_10_10_REV) return false;
  v = {field(0, 10), field(10, 10), field(20, 10), field(30, 2)};
  return true;
}

/// Owns a copy of an array that the program passed, for use after the call. Null stays null.
template <class T>
struct Copy {
  std::vector<T> values;
  bool null = false;
  const T* get() const { return null ? nullptr : values.data(); }
};

template <class T>
Copy<T> copyOf(const T* source, ptrdiff_t count) {
  if (!source) return {{}, true};
  return {std::vector<T>(source, source + (count > 0 ? count : 0)), false};
}

/// Untyped memory: `bytes` counts bytes.
struct CopyBytes {
  std::vector<std::byte> values;
  bool null = false;
  const void* get() const { return null ? nullptr : values.data(); }
};

inline CopyBytes copyOf(const void* source, ptrdiff_t bytes) {
  if (!source) return {{}, true};
  const auto* first = static_cast<const std::byte*>(source);
  return {std::vector<std::byte>(first, first + (bytes > 0 ? bytes : 0)), false};
}

}  // namespace gluray::intercept::stubs
