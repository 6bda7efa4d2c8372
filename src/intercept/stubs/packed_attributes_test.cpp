// Attributes with few bits, compared with GL 4.6, sections 2.3.4 and 10.2.1.
#include "intercept/stubs/packed_attributes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace gluray::intercept::stubs {
namespace {

TEST(HalfToFloat, KnownValues) {
  EXPECT_EQ(halfToFloat(0x0000), 0.0f);
  EXPECT_EQ(halfToFloat(0x3C00), 1.0f);
  EXPECT_EQ(halfToFloat(0xC000), -2.0f);
  EXPECT_EQ(halfToFloat(0x7BFF), 65504.0f);
  EXPECT_EQ(halfToFloat(0x0001), 0x1p-24f);
  EXPECT_EQ(halfToFloat(0x83FF), -1023 * 0x1p-24f);
  EXPECT_TRUE(std::isinf(halfToFloat(0x7C00)));
  EXPECT_TRUE(std::isnan(halfToFloat(0x7E00)));
}

/// Unpacks a value and compares all four components.
void expectUnpacked(PackedRules rules, GLenum type, bool normalised, GLuint value,
                    const std::array<float, 4>& expected) {
  Packed v;
  ASSERT_TRUE(unpack(rules, type, normalised, value, v));
  EXPECT_EQ((std::array<float, 4>{v.x, v.y, v.z, v.w}), expected) << "normalised: " << normalised;
}

TEST(Unpack, UnsignedFields) {
  const GLuint value = 1u | 2u << 10 | 1023u << 20 | 3u << 30;
  expectUnpacked(packedRules(41, false), GL_UNSIGNED_INT_2_10_10_10_REV, false, value, {1, 2, 1023, 3});
  expectUnpacked(packedRules(41, false), GL_UNSIGNED_INT_2_10_10_10_REV, true, value,
                 {1 / 1023.0f, 2 / 1023.0f, 1, 1});
}

TEST(Unpack, SignedFieldsBefore42) {
  const GLuint value = 511u | 512u << 10 | 1023u << 20 | 2u << 30;
  expectUnpacked(packedRules(41, false), GL_INT_2_10_10_10_REV, false, value, {511, -512, -1, -2});
  expectUnpacked(packedRules(41, false), GL_INT_2_10_10_10_REV, true, value, {1, -1, -1 / 1023.0f, -1});
}

TEST(Unpack, SignedFieldsHaveAZeroFrom42On) {
  const GLuint value = 511u | 512u << 10 | 1u << 30, negative = 1023u | 2u << 30;
  expectUnpacked(packedRules(42, false), GL_INT_2_10_10_10_REV, true, value, {1, -1, 0, 1});  // -512 is -511
  expectUnpacked(packedRules(42, false), GL_INT_2_10_10_10_REV, true, negative, {-1 / 511.0f, 0, 0, -1});
}

TEST(Unpack, FloatsOfGenericAttributes) {
  Packed v;
  const GLuint value = 0x3C0u | 0x3E0u << 11 | 0x200u << 22;  // 1, 1.5, 2
  ASSERT_TRUE(unpackGeneric3(packedRules(33, true), GL_UNSIGNED_INT_10F_11F_11F_REV, false, value, v));
  EXPECT_EQ(v.x, 1);
  EXPECT_EQ(v.y, 1.5f);
  EXPECT_EQ(v.z, 2);
  EXPECT_EQ(v.w, 1);
  EXPECT_FALSE(unpackGeneric3(packedRules(33, false), GL_UNSIGNED_INT_10F_11F_11F_REV, false, value, v));
  EXPECT_FALSE(unpack(packedRules(44, true), GL_UNSIGNED_INT_10F_11F_11F_REV, false, value, v));
}

TEST(Unpack, OtherTypesAreRefused) {
  Packed v;
  EXPECT_FALSE(unpack(packedRules(46, true), GL_FLOAT, false, 0, v));
}

}  // namespace
}  // namespace gluray::intercept::stubs
