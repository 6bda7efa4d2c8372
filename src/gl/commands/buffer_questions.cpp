// Handlers of buffer object queries, which the real OpenGL would answer wrongly while contents are held back.
#include "gl/commands/bound_buffer.h"
#include "gl/context/handlers.h"

#include <GL/glext.h>

namespace gluray::gl {

bool answers(const Buffer& buffer, GLenum pname, GLint64* value) {
  if (!buffer.heldBack() && !buffer.mapped()) return false;
  const GLbitfield access = buffer.mapAccess() & (GL_MAP_READ_BIT | GL_MAP_WRITE_BIT);
  switch (pname) {
    case GL_BUFFER_SIZE: *value = static_cast<GLint64>(buffer.size()); return true;
    case GL_BUFFER_USAGE: *value = buffer.usage(); return true;
    case GL_BUFFER_MAPPED: *value = buffer.mapped(); return true;
    case GL_BUFFER_MAP_OFFSET:
      *value = buffer.mapped() ? static_cast<GLint64>(buffer.mapOffset()) : 0;
      return true;
    case GL_BUFFER_MAP_LENGTH:
      *value = buffer.mapped() ? static_cast<GLint64>(buffer.mapLength()) : 0;
      return true;
    case GL_BUFFER_ACCESS_FLAGS: *value = buffer.mapped() ? buffer.mapAccess() : 0; return true;
    case GL_BUFFER_ACCESS:
      *value = !buffer.mapped() || access == (GL_MAP_READ_BIT | GL_MAP_WRITE_BIT) ? GL_READ_WRITE
               : access == GL_MAP_READ_BIT                                        ? GL_READ_ONLY
                                                                                  : GL_WRITE_ONLY;
      return true;
    default: return false;
  }
}

void getBufferParameteriv(Context& c, GLenum target, GLenum pname, GLint* params) {
  GLint64 value = 0;
  const auto buffer = bound(c, target);
  if (buffer && answers(*buffer, pname, &value)) return void(*params = static_cast<GLint>(value));
  c.real.GetBufferParameteriv(target, pname, params);
}

void getBufferParameteri64v(Context& c, GLenum target, GLenum pname, GLint64* params) {
  const auto buffer = bound(c, target);
  if (!buffer || !answers(*buffer, pname, params)) c.real.GetBufferParameteri64v(target, pname, params);
}

void getBufferPointerv(Context& c, GLenum target, GLenum pname, void** params) {
  const auto buffer = bound(c, target);
  if (buffer && buffer->mapped() && pname == GL_BUFFER_MAP_POINTER)
    *params = buffer->mappedPointer();
  else
    c.real.GetBufferPointerv(target, pname, params);
}

}  // namespace gluray::gl
