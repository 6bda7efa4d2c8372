// Queries of the real OpenGL that return their result. Used by gl/ and intercept/present, GL thread.
#pragma once
#include "gl/real/real.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <glm/glm.hpp>

#include <limits>

namespace gluray::gl {

inline GLint integer(const RealGl& real, GLenum name) {
  GLint value = 0;
  real.GetIntegerv(name, &value);
  return value;
}

inline bool isOn(const RealGl& real, GLenum capability) { return real.IsEnabled(capability) == GL_TRUE; }

/// The draw framebuffer's name; 0 if the OpenGL has no framebuffer objects.
inline GLuint drawFramebuffer(const RealGl& real) {
  return isPresent(real.BindFramebuffer) ? static_cast<GLuint>(integer(real, GL_DRAW_FRAMEBUFFER_BINDING))
                                         : 0;
}

/// The bound program pipeline's name; 0: none. `hasPipelines`: RareState::pipelines of the context.
inline GLuint programPipeline(const RealGl& real, bool hasPipelines) {
  return hasPipelines ? static_cast<GLuint>(integer(real, GL_PROGRAM_PIPELINE_BINDING)) : 0;
}

/// Whether fragments are written to more than the first draw buffer.
inline bool hasMoreDrawBuffers(const RealGl& real) {
  if (!isPresent(real.DrawBuffers)) return false;
  const GLint most = integer(real, GL_MAX_DRAW_BUFFERS);
  for (GLint i = 1; i < most; ++i)
    if (integer(real, GL_DRAW_BUFFER0 + static_cast<GLenum>(i)) != GL_NONE) return true;
  return false;
}

/// A parameter of an attachment of the framebuffer bound to `target`.
inline GLint attachmentValue(const RealGl& real, GLenum target, GLenum attachment, GLenum name) {
  GLint value = 0;
  real.GetFramebufferAttachmentParameteriv(target, attachment, name, &value);
  return value;
}

/// Size in pixels of a renderbuffer that exists.
inline glm::ivec2 renderbufferSize(const RealGl& real, GLuint name) {
  glm::ivec2 size(0);
  const GLint bound = integer(real, GL_RENDERBUFFER_BINDING);
  real.BindRenderbuffer(GL_RENDERBUFFER, name);
  real.GetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_WIDTH, &size.x);
  real.GetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_HEIGHT, &size.y);
  real.BindRenderbuffer(GL_RENDERBUFFER, static_cast<GLuint>(bound));
  return size;
}

/// The scissor box (x, y, width, height); a box larger than any framebuffer if the scissor test is off.
inline glm::ivec4 scissorBox(const RealGl& real) {
  constexpr int kAll = std::numeric_limits<int>::max() / 2;
  glm::ivec4 box(0, 0, kAll, kAll);
  if (isOn(real, GL_SCISSOR_TEST)) real.GetIntegerv(GL_SCISSOR_BOX, &box.x);
  return box;
}

}  // namespace gluray::gl
