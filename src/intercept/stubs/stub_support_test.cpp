// The conversions of vertex attributes against GL 2.1, table 2.9, and the table of stubs.
#include "intercept/stubs/stub_support.h"

#include "intercept/stubs/stub_proc.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gluray::intercept::stubs {
namespace {

TEST(Normalised, EndsOfEveryRange) {
  EXPECT_EQ(normalised(GLubyte{0}), 0.0f);
  EXPECT_EQ(normalised(GLubyte{255}), 1.0f);
  EXPECT_EQ(normalised(GLushort{65535}), 1.0f);
  EXPECT_EQ(normalised(GLuint{0xFFFFFFFF}), 1.0f);
  EXPECT_EQ(normalised(GLbyte{127}), 1.0f);
  EXPECT_EQ(normalised(GLbyte{-128}), -1.0f);
  EXPECT_EQ(normalised(GLshort{32767}), 1.0f);
  EXPECT_EQ(normalised(GLshort{-32768}), -1.0f);
  EXPECT_EQ(normalised(GLint{2147483647}), 1.0f);
  EXPECT_EQ(normalised(GLint{-2147483647 - 1}), -1.0f);
}

TEST(Normalised, SignedZeroIsHalfAStepAboveZero) {
  EXPECT_FLOAT_EQ(normalised(GLbyte{0}), 1.0f / 255.0f);
  EXPECT_FLOAT_EQ(normalised(GLshort{0}), 1.0f / 65535.0f);
}

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

TEST(Unpack, UnsignedFields) {
  Packed v;
  const GLuint value = 1u | 2u << 10 | 1023u << 20 | 3u << 30;
  ASSERT_TRUE(unpack(GL_UNSIGNED_INT_2_10_10_10_REV, false, value, v));
  EXPECT_EQ(v.x, 1);
  EXPECT_EQ(v.y, 2);
  EXPECT_EQ(v.z, 1023);
  EXPECT_EQ(v.w, 3);
  ASSERT_TRUE(unpack(GL_UNSIGNED_INT_2_10_10_10_REV, true, value, v));
  EXPECT_FLOAT_EQ(v.x, 1 / 1023.0f);
  EXPECT_EQ(v.z, 1);
  EXPECT_EQ(v.w, 1);
}

TEST(Unpack, SignedFields) {
  Packed v;
  const GLuint value = 511u | 512u << 10 | 1023u << 20 | 2u << 30;  // 511, -512, -1, -2
  ASSERT_TRUE(unpack(GL_INT_2_10_10_10_REV, false, value, v));
  EXPECT_EQ(v.x, 511);
  EXPECT_EQ(v.y, -512);
  EXPECT_EQ(v.z, -1);
  EXPECT_EQ(v.w, -2);
  ASSERT_TRUE(unpack(GL_INT_2_10_10_10_REV, true, value, v));
  EXPECT_EQ(v.x, 1);
  EXPECT_EQ(v.y, -1);
  EXPECT_FLOAT_EQ(v.z, -1 / 1023.0f);
  EXPECT_EQ(v.w, -1);
}

TEST(Unpack, OtherTypesAreRefused) {
  Packed v;
  EXPECT_FALSE(unpack(GL_FLOAT, false, 0, v));
}

TEST(CopyOf, OwnsTheCopy) {
  GLfloat source[] = {1, 2, 3};
  const auto copy = copyOf(source, 3);
  source[1] = 9;
  EXPECT_EQ(copy.get()[1], 2);
  EXPECT_EQ(copyOf(static_cast<const GLfloat*>(nullptr), 3).get(), nullptr);
  EXPECT_TRUE(copyOf(source, -1).values.empty());
  const void* untyped = source;
  EXPECT_EQ(copyOf(untyped, 4).values.size(), 4u);
}

TEST(StubProc, KnowsEveryCommandAndNothingElse) {
  for (const gl::CommandName& command : gl::kCommandNames)
    ASSERT_NE(stubProc(command.name), nullptr) << command.name;
  EXPECT_EQ(stubProc("glNoSuchCommand"), nullptr);
  EXPECT_EQ(stubProc(""), nullptr);
}

TEST(StubProc, AliasesOfModelledCommandsShareTheirStub) {
  EXPECT_EQ(stubProc("glMultiTexCoord2fARB"), stubProc("glMultiTexCoord2f"));
  EXPECT_EQ(stubProc("glBindBufferARB"), stubProc("glBindBuffer"));
  EXPECT_NE(stubProc("glVertex3f"), stubProc("glVertex3d"));
}

TEST(Stubs, WithoutAContextNothingHappens) {
  const auto shadeModel = reinterpret_cast<void (*)(GLenum)>(stubProc("glShadeModel"));
  const auto isTexture = reinterpret_cast<GLboolean (*)(GLuint)>(stubProc("glIsTexture"));
  const auto vertex = reinterpret_cast<void (*)(GLfloat, GLfloat, GLfloat)>(stubProc("glVertex3f"));
  shadeModel(GL_FLAT);
  vertex(0, 0, 0);
  EXPECT_EQ(isTexture(1), GL_FALSE);
}

}  // namespace
}  // namespace gluray::intercept::stubs
