// Vertex attributes with few bits: half precision, and attributes packed into 32 bits (GL 4.6, section
// 10.2.1).
#pragma once
#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace gluray::intercept::stubs {

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

/// The interpretation of packed values, which depends on the context's version and extensions.
struct PackedRules {
  bool hasZero = false;    // signed values are max(c / (2^(b-1) - 1), -1); before GL 4.2 (2c + 1) / (2^b - 1)
  bool hasFloats = false;  // GL_UNSIGNED_INT_10F_11F_11F_REV is a type of generic attributes
};

/// `version`: 10 times major plus minor; `hasFloats`: ContextInfo::packedFloats.
constexpr PackedRules packedRules(int version, bool hasFloats) { return {version >= 42, hasFloats}; }

/// The field of `bits` bits from bit `shift` on, as a signed integer.
constexpr int signedField(GLuint value, int shift, int bits) {
  return static_cast<int>(value << (32 - bits - shift)) >> (32 - bits);
}

inline float normalisedField(PackedRules rules, int c, int bits) {
  if (!rules.hasZero) return static_cast<float>((2.0 * c + 1.0) / ((1 << bits) - 1));
  return std::max(static_cast<float>(c) / static_cast<float>((1 << (bits - 1)) - 1), -1.0f);
}

/// Unpacks an attribute of 10, 10, 10 and 2 bits. Returns false if `type` is neither of the two such types.
inline bool unpack(PackedRules rules, GLenum type, bool normalise, GLuint value, Packed& v) {
  const auto field = [&](int shift, int bits) {
    const uint32_t steps = (1u << bits) - 1u, raw = (value >> shift) & steps;
    if (type == GL_UNSIGNED_INT_2_10_10_10_REV)
      return static_cast<float>(normalise ? raw / static_cast<double>(steps) : raw);
    const int c = signedField(value, shift, bits);
    return normalise ? normalisedField(rules, c, bits) : static_cast<float>(c);
  };
  if (type != GL_UNSIGNED_INT_2_10_10_10_REV && type != GL_INT_2_10_10_10_REV) return false;
  v = {field(0, 10), field(10, 10), field(20, 10), field(30, 2)};
  return true;
}

/// Unpacks three components of a generic attribute, which may also be unsigned floats of 11, 11 and 10 bits.
inline bool unpackGeneric3(PackedRules rules, GLenum type, bool normalise, GLuint value, Packed& v) {
  if (type != GL_UNSIGNED_INT_10F_11F_11F_REV || !rules.hasFloats)
    return unpack(rules, type, normalise, value, v);
  const auto field = [&](int shift, int bits) {  // exponents are those of half floats
    return halfToFloat(static_cast<uint16_t>(((value >> shift) & ((1u << bits) - 1u)) << (15 - bits)));
  };
  v = {field(0, 11), field(11, 11), field(22, 10), 1};
  return true;
}

}  // namespace gluray::intercept::stubs
