// Handlers of commands on buffer objects bound to a target.
#include "gl/commands/bound_buffer.h"
#include "gl/context/handlers.h"

#include <cstring>
#include <new>
#include <utility>

namespace gluray::gl {
namespace {

/// Targets whose buffers the real OpenGL reads only in commands that GLuRay sees.
bool usesAreSeen(GLenum target) {
  switch (target) {
    case GL_ARRAY_BUFFER:
    case GL_ELEMENT_ARRAY_BUFFER:
    case GL_COPY_READ_BUFFER:
    case GL_COPY_WRITE_BUFFER:
    case GL_PIXEL_PACK_BUFFER: return true;
    default: return false;
  }
}

/// Whether contents sent to `target` are held back until a draw of the real OpenGL reads them. Always false
/// in passthrough frames.
bool isHeldBack(const Context& c, GLenum target, const Buffer* buffer) {
  if (buffer && (buffer->readBelow || buffer->foreign || buffer->isSentOften())) return false;
  return !c.clock.passesThrough() && (target == GL_ARRAY_BUFFER || target == GL_ELEMENT_ARRAY_BUFFER);
}

bool isRange(const Buffer& buffer, GLintptr offset, GLsizeiptr size) {
  return offset >= 0 && size >= 0 && static_cast<size_t>(offset) <= buffer.size() &&
         static_cast<size_t>(size) <= buffer.size() - static_cast<size_t>(offset);
}

/// Whether to map the real OpenGL's memory instead of our copy. If so, it has our contents afterwards.
bool isMappedBelow(Context& c, Buffer* buffer, GLenum target) {
  if (buffer && !buffer->immutable && !buffer->mappedBelow && isHeldBack(c, target, buffer)) {
    if (!buffer->heldBack()) buffer->readToWrite(c.real);
    if (buffer->size() > 0) return false;  // empty: the real OpenGL raises the error
  }
  if (buffer && !buffer->mapped()) buffer->sendTo(c.real), buffer->changedBelow();
  return true;
}

/// Also marks the arrays as dirty, because they cannot be read while the buffer is mapped.
void setMappedBelow(Context& c, Buffer& buffer, bool mapped) {
  buffer.mappedBelow = mapped;
  c.touch(kArrays);
}

bool isUsage(GLenum usage) { return usage >= GL_STREAM_DRAW && usage <= GL_DYNAMIC_COPY && (usage & 3) != 3; }

}  // namespace

void bindBuffer(Context& c, GLenum target, GLuint name) {
  c.real.BindBuffer(target, name);
  if (const auto buffer = bufferNamed(c.shadow.group, name); buffer && !isHeldBack(c, target, buffer.get())) {
    buffer->sendTo(c.real);
    if (!usesAreSeen(target)) buffer->showMapping(c.real);
    buffer->readBelow = buffer->readBelow || !usesAreSeen(target);
  }
  if (target != GL_ELEMENT_ARRAY_BUFFER) return c.shadow.attachments.setTarget(target);
  c.touch(kArrays);
  c.shadow.attachments.set(Attachments::kElements);
}

void deleteBuffers(Context& c, GLsizei n, const GLuint* names) {
  c.touch(kArrays);
  // Vertex array objects of this context or others may still draw from them.
  const bool livesOn = c.shadow.attachments.any() || c.shadow.group.contexts > 1;
  for (GLsizei i = 0; names && i < n; ++i) {
    c.flusher.contentsChange(names[i]);
    const auto buffer = c.shadow.group.buffers.find(names[i]);
    if (buffer && livesOn) c.protect([&] { buffer->sendTo(c.real); });
    if (buffer && livesOn) c.failsafe.insist([&] { c.shadow.group.deletedBuffers.add(names[i]); });
  }
  c.real.DeleteBuffers(n, names);
  for (GLsizei i = 0; names && i < n; ++i) c.shadow.group.buffers.erase(names[i]);
}

void bufferData(Context& c, GLenum target, GLsizeiptr size, const void* data, GLenum usage) {
  const auto buffer = bound(c, target);
  if (buffer) c.flusher.contentsChange(buffer->name());
  if (!buffer || size < 0 || buffer->immutable || !isUsage(usage))
    return c.real.BufferData(target, size, data, usage);
  if (buffer->mappedBelow) {  // new contents end a mapping
    c.real.UnmapBuffer(target);
    setMappedBelow(c, *buffer, false);
  }
  if (isHeldBack(c, target, buffer.get()) && size > 0) {
    try {
      return buffer->setData(static_cast<size_t>(size), data, usage);
    } catch (const std::bad_alloc&) {}  // no memory for our copy: the real OpenGL has the only one
  }
  c.real.BufferData(target, size, data, usage);
  buffer->setSizeBelow(static_cast<size_t>(size), usage);
}

void bufferSubData(Context& c, GLenum target, GLintptr offset, GLsizeiptr size, const void* data) {
  const auto buffer = bound(c, target);
  if (!buffer) return c.real.BufferSubData(target, offset, size, data);
  c.flusher.contentsChange(buffer->name());
  if (buffer->mapped() && !isRange(*buffer, offset, size)) return c.errors.set(GL_INVALID_VALUE);
  if (buffer->mappedIn(static_cast<size_t>(offset), static_cast<size_t>(size)))
    return c.errors.set(GL_INVALID_OPERATION);
  if (buffer->mappedBelow || buffer->showsMapping())
    return c.real.BufferSubData(target, offset, size, data);  // the real OpenGL checks the range
  try {
    const bool ours = buffer->mapped() || (!buffer->immutable && isHeldBack(c, target, buffer.get()));
    if (ours && buffer->readToWrite(c.real)) {
      if (!isRange(*buffer, offset, size)) return c.errors.set(GL_INVALID_VALUE);
      if (size > 0 && data) buffer->setSubData(static_cast<size_t>(offset), static_cast<size_t>(size), data);
      return;
    }
  } catch (const std::bad_alloc&) {}  // no memory for our copy: the real OpenGL has the only one
  buffer->sendTo(c.real);
  c.real.BufferSubData(target, offset, size, data);
  buffer->changedBelow();
}

void bufferStorage(Context& c, GLenum target, GLsizeiptr size, const void* data, GLbitfield flags) {
  const auto buffer = bound(c, target);
  if (buffer) buffer->sendTo(c.real);  // kept if the real OpenGL refuses the storage
  c.real.BufferStorage(target, size, data, flags);
  GLint immutable = GL_FALSE;
  if (buffer && !buffer->immutable)
    c.real.GetBufferParameteriv(target, GL_BUFFER_IMMUTABLE_STORAGE, &immutable);
  if (immutable == GL_FALSE) return;
  buffer->setSizeBelow(static_cast<size_t>(std::max<GLsizeiptr>(size, 0)), GL_DYNAMIC_DRAW);
  buffer->immutable = true;
  if (flags & GL_MAP_PERSISTENT_BIT) buffer->foreign = buffer->persistent = true;
}

void* mapBuffer(Context& c, GLenum target, GLenum access) {
  GLbitfield bits = 0;
  switch (access) {
    case GL_READ_ONLY: bits = GL_MAP_READ_BIT; break;
    case GL_WRITE_ONLY: bits = GL_MAP_WRITE_BIT; break;
    case GL_READ_WRITE: bits = GL_MAP_READ_BIT | GL_MAP_WRITE_BIT; break;
    default: return c.errors.set(GL_INVALID_ENUM), nullptr;
  }
  const auto buffer = bound(c, target);
  if (buffer) c.flusher.contentsChange(buffer->name());
  if (buffer && buffer->mapped()) return c.errors.set(GL_INVALID_OPERATION), nullptr;
  if (isMappedBelow(c, buffer.get(), target)) {
    void* memory = c.real.MapBuffer(target, access);
    if (buffer && memory) setMappedBelow(c, *buffer, true);
    return memory;
  }
  return buffer->map(c.real, 0, buffer->size(), bits);
}

/// Whether glMapBufferRange accepts these bits for a buffer made by glBufferData.
bool isAccess(GLbitfield access) {
  constexpr GLbitfield kReadWrite = GL_MAP_READ_BIT | GL_MAP_WRITE_BIT;
  constexpr GLbitfield kNotToRead =
      GL_MAP_INVALIDATE_RANGE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT | GL_MAP_UNSYNCHRONIZED_BIT;
  if ((access & ~(kReadWrite | kNotToRead | GL_MAP_FLUSH_EXPLICIT_BIT)) || !(access & kReadWrite))
    return false;
  if ((access & GL_MAP_READ_BIT) && (access & kNotToRead)) return false;
  return (access & GL_MAP_WRITE_BIT) || !(access & GL_MAP_FLUSH_EXPLICIT_BIT);
}

void* mapBufferRange(Context& c, GLenum target, GLintptr offset, GLsizeiptr length, GLbitfield access) {
  const auto buffer = bound(c, target);
  if (buffer) c.flusher.contentsChange(buffer->name());
  if (buffer && buffer->mapped())
    return c.errors.set(isRange(*buffer, offset, length) ? GL_INVALID_OPERATION : GL_INVALID_VALUE), nullptr;
  const bool refused = buffer && !isAccess(access);  // the real OpenGL raises the error
  if (refused) buffer->sendTo(c.real);
  if (refused || isMappedBelow(c, buffer.get(), target)) {
    void* memory = c.real.MapBufferRange(target, offset, length, access);
    if (buffer && memory) setMappedBelow(c, *buffer, true);
    return memory;
  }
  if (!isRange(*buffer, offset, length)) return c.errors.set(GL_INVALID_VALUE), nullptr;
  if (length == 0) return c.errors.set(GL_INVALID_OPERATION), nullptr;
  return buffer->map(c.real, static_cast<size_t>(offset), static_cast<size_t>(length), access);
}

GLboolean unmapBuffer(Context& c, GLenum target) {
  const auto buffer = bound(c, target);
  const bool below = buffer && buffer->mappedBelow;
  if (below) setMappedBelow(c, *buffer, false);
  if (!buffer || !buffer->mapped()) {
    const GLboolean kept = c.real.UnmapBuffer(target);
    if (below) buffer->changedBelow();
    return kept;
  }
  buffer->unmap(c.real);
  if (buffer->readBelow || buffer->foreign) buffer->sendTo(c.real);
  return GL_TRUE;
}

void flushMappedBufferRange(Context& c, GLenum target, GLintptr offset, GLsizeiptr length) {
  const auto buffer = bound(c, target);
  if (!buffer || !buffer->mapped()) return c.real.FlushMappedBufferRange(target, offset, length);
  if (const GLenum error = buffer->flushError(offset, length)) c.errors.set(error);
}

void getBufferSubData(Context& c, GLenum target, GLintptr offset, GLsizeiptr size, void* data) {
  const auto buffer = bound(c, target);
  if (!buffer || (!buffer->heldBack() && !buffer->mapped()))
    return c.real.GetBufferSubData(target, offset, size, data);
  if (!isRange(*buffer, offset, size)) return c.errors.set(GL_INVALID_VALUE);
  if (buffer->mapped()) return c.errors.set(GL_INVALID_OPERATION);
  std::memcpy(data, buffer->read(c.real)->data + offset, static_cast<size_t>(size));
}

void copyBufferSubData(Context& c, GLenum readTarget, GLenum writeTarget, GLintptr readOffset,
                       GLintptr writeOffset, GLsizeiptr size) {
  const auto source = bound(c, readTarget), target = bound(c, writeTarget);
  // The real OpenGL does not know mappings of our copy.
  if ((source && source->mapped()) || (target && target->mapped())) return c.errors.set(GL_INVALID_OPERATION);
  if (target) c.flusher.contentsChange(target->name());
  if (source) source->sendTo(c.real);
  if (target) target->sendTo(c.real);
  c.real.CopyBufferSubData(readTarget, writeTarget, readOffset, writeOffset, size);
  if (target) target->changedBelow();
}

uint32_t boundBufferChanged(Context& c, GLenum target) {
  c.protect([&] {
    if (const auto buffer = bound(c, target)) {
      c.flusher.contentsChange(buffer->name());
      buffer->sendTo(c.real);
      buffer->showMapping(c.real);
      buffer->changedBelow();
    }
  });
  return kArrays;
}

uint32_t packBufferChanged(Context& c) {
  return versionOf(c.real) < 21 ? 0 : boundBufferChanged(c, GL_PIXEL_PACK_BUFFER);
}

uint32_t queryBufferChanged(Context& c) {
  return versionOf(c.real) < 44 ? 0 : boundBufferChanged(c, GL_QUERY_BUFFER);
}

uint32_t boundStorageForeign(Context& c, GLenum target) {
  const auto buffer = bound(c, target);
  return buffer ? bufferForeign(c, buffer->name()) : 0;
}

uint32_t buffersChangedBelow(Context& c) {
  c.protect([&] {
    for (const auto& buffer : c.shadow.group.buffers.all()) {
      c.flusher.contentsChange(buffer->name());
      buffer->sendTo(c.real);
      buffer->changedBelow();
    }
  });
  return kArrays;
}

}  // namespace gluray::gl
