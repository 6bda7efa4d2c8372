#include "gl/textures/drawn_textures.h"

#include "gl/real/state_queries.h"

#include <GL/gl.h>
#include <GL/glext.h>

namespace gluray::gl {

std::vector<GLuint> texturesDrawnTo(const RealGl& real) {
  std::vector<GLuint> names;
  if (integer(real, GL_DRAW_FRAMEBUFFER_BINDING) == 0) return names;
  const auto ask = [&](GLenum attachment, GLenum what) {
    GLint value = 0;
    real.GetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, what, &value);
    return value;
  };
  const auto look = [&](GLenum attachment) {
    if (ask(attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) == GL_TEXTURE)
      names.push_back(static_cast<GLuint>(ask(attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME)));
  };
  const GLint colors = integer(real, GL_MAX_COLOR_ATTACHMENTS);
  for (GLint i = 0; i < colors; ++i) look(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i));
  look(GL_DEPTH_ATTACHMENT), look(GL_STENCIL_ATTACHMENT);
  return names;
}

}  // namespace gluray::gl
