#include "gl/real/buffer_bits.h"

#include "gl/real/state_queries.h"

#include <GL/glext.h>

namespace gluray::gl {
namespace {

/// Querying the size of a missing attachment is an error, so the attachment's type is queried first.
GLint sizeOf(const RealGl& real, GLenum attachment, GLenum name) {
  if (attachmentValue(real, GL_DRAW_FRAMEBUFFER, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) ==
      GL_NONE)
    return 0;
  return attachmentValue(real, GL_DRAW_FRAMEBUFFER, attachment, name);
}

/// The attachment name of a buffer of the default framebuffer.
GLenum attachmentOfWindow(GLenum drawBuffer) {
  switch (drawBuffer) {
    case GL_BACK:
    case GL_BACK_LEFT: return GL_BACK_LEFT;
    case GL_BACK_RIGHT: return GL_BACK_RIGHT;
    case GL_FRONT_RIGHT: return GL_FRONT_RIGHT;
    default: return GL_FRONT_LEFT;
  }
}

/// The attachment of the draw framebuffer that glDrawBuffer(`drawBuffer`) names.
GLenum attachmentOf(const RealGl& real, GLenum drawBuffer) {
  return integer(real, GL_DRAW_FRAMEBUFFER_BINDING) == 0 ? attachmentOfWindow(drawBuffer) : drawBuffer;
}

}  // namespace

GLint depthBits(const RealGl& real, bool fixedFunction) {
  if (fixedFunction) return integer(real, GL_DEPTH_BITS);
  const bool window = integer(real, GL_DRAW_FRAMEBUFFER_BINDING) == 0;
  return sizeOf(real, window ? GL_DEPTH : GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
}

GLint redBits(const RealGl& real, GLenum drawBuffer, bool fixedFunction) {
  if (drawBuffer == GL_NONE) return 0;
  if (fixedFunction) return integer(real, GL_RED_BITS);
  return sizeOf(real, attachmentOf(real, drawBuffer), GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE);
}

glm::ivec4 colorBits(const RealGl& real, GLenum drawBuffer) {
  if (drawBuffer == GL_NONE) return glm::ivec4(0);
  const GLenum attachment = attachmentOf(real, drawBuffer);
  const auto size = [&](GLenum name) { return sizeOf(real, attachment, name); };
  return {size(GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE), size(GL_FRAMEBUFFER_ATTACHMENT_GREEN_SIZE),
          size(GL_FRAMEBUFFER_ATTACHMENT_BLUE_SIZE), size(GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE)};
}

}  // namespace gluray::gl
