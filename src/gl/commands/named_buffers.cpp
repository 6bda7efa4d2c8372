// Handlers of direct state access to buffer objects (OpenGL 4.5, EXT_direct_state_access), and of commands
// that let the real OpenGL read or write buffers without GLuRay seeing it.
#include "gl/context/handlers.h"

#include <utility>

namespace gluray::gl {
namespace {

std::shared_ptr<Buffer> known(Context& c, GLuint name) {
  return name ? c.shadow.group.buffers.find(name) : nullptr;
}

void markForeign(Context& c, GLuint name) {
  c.protect([&] {
    const auto buffer = bufferNamed(c.shadow.group, name);
    if (!buffer) return;
    c.flusher.contentsChange(name);
    buffer->sendTo(c.real);
    buffer->foreign = true;
    c.touch(kArrays);
  });
}

/// `map` maps the buffer in the real OpenGL.
template <class Map>
void* mapNamed(Context& c, GLuint name, Map&& map) {
  const auto buffer = known(c, name);
  if (!buffer) return map();
  if (buffer->mapped()) return c.errors.set(GL_INVALID_OPERATION), nullptr;
  namedBufferChanged(c, name);
  void* memory = map();
  if (memory) buffer->mappedBelow = true, c.touch(kArrays);
  return memory;
}

template <class Unmap>
GLboolean unmapNamed(Context& c, GLuint name, Unmap&& unmap) {
  const auto buffer = known(c, name);
  if (!buffer || !buffer->mapped()) {
    const GLboolean kept = unmap();
    if (buffer && std::exchange(buffer->mappedBelow, false)) buffer->changedBelow(), c.touch(kArrays);
    return kept;
  }
  buffer->unmap(c.real);
  if (buffer->readBelow || buffer->foreign) buffer->sendTo(c.real);
  return GL_TRUE;
}

/// Handles the flush of a mapping of our copy. Returns false if there is none.
bool handlesFlush(Context& c, GLuint name, GLintptr offset, GLsizeiptr length) {
  const auto buffer = known(c, name);
  if (!buffer || !buffer->mapped()) return false;
  if (const GLenum error = buffer->flushError(offset, length)) c.errors.set(error);
  return true;
}

bool answersPointer(Context& c, GLuint name, GLenum pname, void** params) {
  const auto buffer = known(c, name);
  if (!buffer || !buffer->mapped() || pname != GL_BUFFER_MAP_POINTER) return false;
  *params = buffer->mappedPointer();
  return true;
}

template <class T>
bool answersParameter(Context& c, GLuint name, GLenum pname, T* params) {
  GLint64 value = 0;
  const auto buffer = known(c, name);
  if (!buffer || !answers(*buffer, pname, &value)) return false;
  *params = static_cast<T>(value);
  return true;
}

}  // namespace

void* mapNamedBuffer(Context& c, GLuint name, GLenum access) {
  return mapNamed(c, name, [&] { return c.real.MapNamedBuffer(name, access); });
}
void* mapNamedBufferEXT(Context& c, GLuint name, GLenum access) {
  return mapNamed(c, name, [&] { return c.real.MapNamedBufferEXT(name, access); });
}
void* mapNamedBufferRange(Context& c, GLuint name, GLintptr offset, GLsizeiptr length, GLbitfield access) {
  return mapNamed(c, name, [&] { return c.real.MapNamedBufferRange(name, offset, length, access); });
}
void* mapNamedBufferRangeEXT(Context& c, GLuint name, GLintptr offset, GLsizeiptr length, GLbitfield access) {
  return mapNamed(c, name, [&] { return c.real.MapNamedBufferRangeEXT(name, offset, length, access); });
}

GLboolean unmapNamedBuffer(Context& c, GLuint name) {
  return unmapNamed(c, name, [&] { return c.real.UnmapNamedBuffer(name); });
}
GLboolean unmapNamedBufferEXT(Context& c, GLuint name) {
  return unmapNamed(c, name, [&] { return c.real.UnmapNamedBufferEXT(name); });
}

void flushMappedNamedBufferRange(Context& c, GLuint name, GLintptr offset, GLsizeiptr length) {
  if (!handlesFlush(c, name, offset, length)) c.real.FlushMappedNamedBufferRange(name, offset, length);
}
void flushMappedNamedBufferRangeEXT(Context& c, GLuint name, GLintptr offset, GLsizeiptr length) {
  if (!handlesFlush(c, name, offset, length)) c.real.FlushMappedNamedBufferRangeEXT(name, offset, length);
}

void getNamedBufferPointerv(Context& c, GLuint name, GLenum pname, void** params) {
  if (!answersPointer(c, name, pname, params)) c.real.GetNamedBufferPointerv(name, pname, params);
}
void getNamedBufferPointervEXT(Context& c, GLuint name, GLenum pname, void** params) {
  if (!answersPointer(c, name, pname, params)) c.real.GetNamedBufferPointervEXT(name, pname, params);
}
void getNamedBufferParameteriv(Context& c, GLuint name, GLenum pname, GLint* params) {
  if (!answersParameter(c, name, pname, params)) c.real.GetNamedBufferParameteriv(name, pname, params);
}
void getNamedBufferParameterivEXT(Context& c, GLuint name, GLenum pname, GLint* params) {
  if (!answersParameter(c, name, pname, params)) c.real.GetNamedBufferParameterivEXT(name, pname, params);
}
void getNamedBufferParameteri64v(Context& c, GLuint name, GLenum pname, GLint64* params) {
  if (!answersParameter(c, name, pname, params)) c.real.GetNamedBufferParameteri64v(name, pname, params);
}

uint32_t namedBufferRead(Context& c, GLuint name) {
  c.protect([&] {
    if (const auto buffer = known(c, name)) buffer->sendTo(c.real), buffer->showMapping(c.real);
  });
  return 0;
}

uint32_t namedBufferChanged(Context& c, GLuint name) {
  c.protect([&] {
    const auto buffer = known(c, name);
    if (!buffer) return;
    c.flusher.contentsChange(name);
    buffer->sendTo(c.real);
    buffer->showMapping(c.real);
    buffer->changedBelow();
  });
  return kArrays;
}

uint32_t namedBufferReplaced(Context& c, GLuint name) {
  if (const auto buffer = known(c, name)) {
    if (buffer->mapped()) buffer->unmap(c.real);  // new contents end a mapping
    buffer->mappedBelow = false;
  }
  return namedBufferChanged(c, name);
}

uint32_t namedBufferCopied(Context& c, GLuint from, GLuint to) {
  return namedBufferRead(c, from) | namedBufferChanged(c, to);
}

uint32_t namedStorage(Context& c, GLuint name, GLbitfield flags) {
  if (const auto buffer = bufferNamed(c.shadow.group, name))
    buffer->immutable = true, buffer->persistent = (flags & GL_MAP_PERSISTENT_BIT) != 0;
  if (flags & GL_MAP_PERSISTENT_BIT) markForeign(c, name);
  return namedBufferReplaced(c, name);
}

uint32_t bufferForeign(Context& c, GLuint name) {
  markForeign(c, name);
  return kArrays;
}

uint32_t buffersForeign(Context& c, GLsizei count, const GLuint* names) {
  for (GLsizei i = 0; names && i < count; ++i) markForeign(c, names[i]);
  return kArrays | kProgram;
}

uint32_t readAsTexture(Context& c, GLuint name) {
  c.protect([&] {
    const auto buffer = bufferNamed(c.shadow.group, name);
    if (!buffer) return;
    buffer->sendTo(c.real);
    buffer->readBelow = true;
  });
  return kTexture;
}

void bindBufferBase(Context& c, GLenum, GLuint, GLuint name) { markForeign(c, name); }
void bindBufferRange(Context& c, GLenum, GLuint, GLuint name, GLintptr, GLsizeiptr) { markForeign(c, name); }

}  // namespace gluray::gl
