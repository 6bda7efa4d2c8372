// Buffer sizes from a fake OpenGL that follows the specification: core profiles refuse the old names, and
// querying the size of a missing attachment is an error.
#include "gl/real/buffer_bits.h"

#include <GL/glext.h>
#include <gtest/gtest.h>

#include <map>

namespace gluray::gl {
namespace {

struct Target {
  bool core = true;
  GLint framebuffer = 0;
  std::map<GLenum, GLint> sizes;  // bits, by attachment
  GLenum error = GL_NO_ERROR;
};
Target g_target;

void APIENTRY getInteger(GLenum name, GLint* value) {
  if (name == GL_DRAW_FRAMEBUFFER_BINDING) {
    *value = g_target.framebuffer;
  } else if (g_target.core) {
    g_target.error = GL_INVALID_ENUM;
  } else {
    *value = name == GL_DEPTH_BITS ? 16 : 5;
  }
}

void APIENTRY getAttachment(GLenum, GLenum attachment, GLenum name, GLint* value) {
  const bool ofWindow = attachment == GL_DEPTH || attachment < GL_COLOR_ATTACHMENT0;
  const auto size = g_target.sizes.find(attachment);
  if (ofWindow != (g_target.framebuffer == 0) || !g_target.core) {
    g_target.error = GL_INVALID_OPERATION;
  } else if (name == GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) {
    *value = size == g_target.sizes.end() ? GL_NONE : ofWindow ? GL_FRAMEBUFFER_DEFAULT : GL_TEXTURE;
  } else if (size == g_target.sizes.end()) {
    g_target.error = GL_INVALID_OPERATION;
  } else {
    *value = size->second;
  }
}

RealGl table() {
  RealGl real;
  loadRealGl(
      real, [](void*, const char*) -> void* { return nullptr; }, nullptr);
  real.GetIntegerv = getInteger;
  real.GetFramebufferAttachmentParameteriv = getAttachment;
  return real;
}

class BufferBits : public testing::Test {
 protected:
  ~BufferBits() override { EXPECT_EQ(g_target.error, GLenum{GL_NO_ERROR}); }
  RealGl real_ = table();
};

TEST_F(BufferBits, ColorsOfAWindowWithoutABackBuffer) {
  g_target = {.sizes = {{GL_FRONT_LEFT, 8}}};
  EXPECT_EQ(colorBits(real_, GL_FRONT), glm::ivec4(8));
  EXPECT_EQ(colorBits(real_, GL_BACK), glm::ivec4(0));
  EXPECT_EQ(colorBits(real_, GL_NONE), glm::ivec4(0));
}

TEST_F(BufferBits, CoreProfileWindow) {
  g_target = {.sizes = {{GL_DEPTH, 24}, {GL_BACK_LEFT, 8}, {GL_FRONT_LEFT, 10}}};
  EXPECT_EQ(depthBits(real_, false), 24);
  EXPECT_EQ(redBits(real_, GL_BACK, false), 8);
  EXPECT_EQ(redBits(real_, GL_BACK_LEFT, false), 8);
  EXPECT_EQ(redBits(real_, GL_FRONT, false), 10);
}

TEST_F(BufferBits, CoreProfileWindowWithoutBuffers) {
  g_target = {};
  EXPECT_EQ(depthBits(real_, false), 0);
  EXPECT_EQ(redBits(real_, GL_BACK, false), 0);
  EXPECT_EQ(redBits(real_, GL_NONE, false), 0);
}

TEST_F(BufferBits, FramebufferObjects) {
  g_target = {.framebuffer = 7, .sizes = {{GL_DEPTH_ATTACHMENT, 32}, {GL_COLOR_ATTACHMENT0 + 1, 16}}};
  EXPECT_EQ(depthBits(real_, false), 32);
  EXPECT_EQ(redBits(real_, GL_COLOR_ATTACHMENT0 + 1, false), 16);
  EXPECT_EQ(redBits(real_, GL_COLOR_ATTACHMENT0, false), 0);
}

TEST_F(BufferBits, CompatibilityProfiles) {
  g_target = {.core = false};
  EXPECT_EQ(depthBits(real_, true), 16);
  EXPECT_EQ(redBits(real_, GL_BACK, true), 5);
}

}  // namespace
}  // namespace gluray::gl
