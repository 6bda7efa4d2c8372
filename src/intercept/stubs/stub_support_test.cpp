// Conversions of vertex attributes, compared with GL 2.1, table 2.9, and the table of stubs.
#include "intercept/stubs/stub_support.h"

#include "intercept/stubs/stub_proc.h"

#include <gtest/gtest.h>

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
