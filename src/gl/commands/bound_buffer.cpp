#include "gl/commands/bound_buffer.h"

#include "gl/context/context.h"

#include <GL/glext.h>

namespace gluray::gl {

GLenum bindingOf(GLenum target) {
  switch (target) {
    case GL_ARRAY_BUFFER: return GL_ARRAY_BUFFER_BINDING;
    case GL_ELEMENT_ARRAY_BUFFER: return GL_ELEMENT_ARRAY_BUFFER_BINDING;
    case GL_PIXEL_PACK_BUFFER: return GL_PIXEL_PACK_BUFFER_BINDING;
    case GL_PIXEL_UNPACK_BUFFER: return GL_PIXEL_UNPACK_BUFFER_BINDING;
    case GL_COPY_READ_BUFFER: return GL_COPY_READ_BUFFER_BINDING;
    case GL_COPY_WRITE_BUFFER: return GL_COPY_WRITE_BUFFER_BINDING;
    case GL_UNIFORM_BUFFER: return GL_UNIFORM_BUFFER_BINDING;
    case GL_TRANSFORM_FEEDBACK_BUFFER: return GL_TRANSFORM_FEEDBACK_BUFFER_BINDING;
    case GL_TEXTURE_BUFFER: return GL_TEXTURE_BUFFER_BINDING;
    case GL_SHADER_STORAGE_BUFFER: return GL_SHADER_STORAGE_BUFFER_BINDING;
    case GL_ATOMIC_COUNTER_BUFFER: return GL_ATOMIC_COUNTER_BUFFER_BINDING;
    case GL_DRAW_INDIRECT_BUFFER: return GL_DRAW_INDIRECT_BUFFER_BINDING;
    case GL_DISPATCH_INDIRECT_BUFFER: return GL_DISPATCH_INDIRECT_BUFFER_BINDING;
    case GL_QUERY_BUFFER: return GL_QUERY_BUFFER_BINDING;
    default: return 0;
  }
}

std::shared_ptr<Buffer> bound(Context& c, GLenum target) {
  const GLenum query = bindingOf(target);
  if (!query) return nullptr;
  GLint name = 0;
  c.real.GetIntegerv(query, &name);
  if (!c.shadow.attachments.mayBeDeletedAt(target, static_cast<GLuint>(name)))
    return bufferNamed(c.shadow.group, static_cast<GLuint>(name));
  if (const auto buffer = c.shadow.group.buffers.find(static_cast<GLuint>(name))) {
    c.flusher.contentsChange(buffer->name());
    buffer->sendTo(c.real);
    buffer->changedBelow();
  }
  return nullptr;
}

}  // namespace gluray::gl
