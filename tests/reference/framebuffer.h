// Framebuffer objects of renderbuffers, for tests.
#pragma once
#include "gl/real/real.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <glm/glm.hpp>
#include <gtest/gtest.h>

namespace gluray::test {

/// Makes and binds a framebuffer object of `size` pixels with colour and depth buffers of these formats.
/// `samples` 0: not multisampled.
inline void bindNewFramebuffer(const gl::RealGl& gl, glm::ivec2 size, GLenum color, GLenum depth,
                               GLsizei samples = 0) {
  GLuint framebuffer = 0, images[2] = {};
  gl.GenFramebuffers(1, &framebuffer), gl.GenRenderbuffers(2, images);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  const auto attach = [&](GLuint image, GLenum format, GLenum attachment) {
    gl.BindRenderbuffer(GL_RENDERBUFFER, image);
    if (samples > 0)
      gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, size.x, size.y);
    else
      gl.RenderbufferStorage(GL_RENDERBUFFER, format, size.x, size.y);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, image);
  };
  attach(images[0], color, GL_COLOR_ATTACHMENT0);
  attach(images[1], depth, depth == GL_DEPTH24_STENCIL8 ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT);
  ASSERT_EQ(gl.CheckFramebufferStatus(GL_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
}

}  // namespace gluray::test
