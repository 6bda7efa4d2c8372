// Handlers of commands that compile, call and delete display lists.
#include "gl/context/handlers.h"
#include "gl/context/list.h"
#include "gl/context/stub.h"

#include <cstring>
#include <vector>

namespace gluray::gl {

void newList(Context& c, GLuint name, GLenum mode) {
  c.failsafe.insist([&] { c.lists.newList(name, mode); });
}
void endList(Context& c) {
  c.failsafe.insist([&] { c.lists.endList(); });
}

namespace {

/// Whether list calls are recorded in the list being compiled. Inside that list's glBegin, the primitive is
/// then recorded call by call, because the called list may change before it is executed. Inside a primitive
/// that the real OpenGL compiles, list calls are executed instead and become part of the primitive.
bool recordsCalls(Context& c) {
  if (!c.lists.compiling()) return false;
  if (c.immediate.inside() == Immediate::Inside::captured) c.failsafe.insist([&] { c.immediate.loosen(); });
  return !c.immediate.insideBegin();
}

}  // namespace

void callList(Context& c, GLuint name) {
  if (recordsCalls(c)) {
    return c.lists.record(
        [name](Context& x) { name ? x.lists.callList(name) : x.errors.set(GL_INVALID_VALUE); }, true);
  }
  if (name == 0) return c.errors.set(GL_INVALID_VALUE);  // as Mesa does; the specification does not say
  c.lists.callList(name);
}

namespace {

/// Offset i of glCallLists (GL 2.1, 5.4). `type` is valid.
GLuint listOffset(GLenum type, const void* names, size_t i) {
  const auto* bytes = static_cast<const GLubyte*>(names);
  const auto load = [&]<class T>(T) {
    T value;
    std::memcpy(&value, bytes + i * sizeof(T), sizeof value);
    return static_cast<GLuint>(static_cast<GLint>(value));
  };
  switch (type) {
    case GL_BYTE: return load(GLbyte{});
    case GL_UNSIGNED_BYTE: return load(GLubyte{});
    case GL_SHORT: return load(GLshort{});
    case GL_UNSIGNED_SHORT: return load(GLushort{});
    case GL_INT: return load(GLint{});
    case GL_UNSIGNED_INT: return load(GLuint{});
    case GL_FLOAT: return load(GLfloat{});
    case GL_2_BYTES: return bytes[2 * i] * 256u + bytes[2 * i + 1];
    case GL_3_BYTES: return bytes[3 * i] * 65536u + bytes[3 * i + 1] * 256u + bytes[3 * i + 2];
    default:
      return bytes[4 * i] * 16777216u + bytes[4 * i + 1] * 65536u + bytes[4 * i + 2] * 256u +
             bytes[4 * i + 3];
  }
}

}  // namespace

void callLists(Context& c, GLsizei n, GLenum type, const void* names) {
  if (n < 0) return c.errors.set(GL_INVALID_VALUE);
  if (!((type >= GL_BYTE && type <= GL_FLOAT) || (type >= GL_2_BYTES && type <= GL_4_BYTES)))
    return c.errors.set(GL_INVALID_ENUM);
  std::vector<GLuint> offsets;
  c.failsafe.insist([&] { offsets.resize(static_cast<size_t>(n)); });
  for (size_t i = 0; i < offsets.size(); ++i) offsets[i] = listOffset(type, names, i);
  const auto call = [offsets = std::move(offsets)](Context& x) {
    const GLuint base = x.lists.base;  // read before the lists run, which may change it
    for (const GLuint offset : offsets) x.lists.callList(base + offset);
  };
  if (recordsCalls(c)) return c.lists.record(call, true);
  call(c);
}

GLuint genLists(Context& c, GLsizei range) {
  if (range < 0) return c.errors.set(GL_INVALID_VALUE), 0;
  return range == 0 ? 0 : c.shadow.group.lists.reserve(static_cast<GLuint>(range));
}

void deleteLists(Context& c, GLuint first, GLsizei range) {
  if (range < 0) return c.errors.set(GL_INVALID_VALUE);
  c.shadow.group.lists.eraseRange(first, static_cast<GLuint>(range));
  c.shadow.group.listLabels.eraseRange(first, static_cast<GLuint>(range));
}

GLboolean isList(Context& c, GLuint name) {
  return name != 0 && c.shadow.group.lists.contains(name) ? GL_TRUE : GL_FALSE;
}

void listBase(Context& c, GLuint base) {
  if (c.lists.compiling()) return c.lists.record([base](Context& x) { x.lists.base = base; });
  c.lists.base = base;
}

void useXFont(Context& c, int first, int count, int base, const std::function<void(int realBase)>& make) {
  (void)first;
  if (count <= 0) return make(base);  // the real OpenGL raises the error
  const GLuint realBase = c.real.GenLists(count);
  if (!realBase) return c.errors.set(GL_OUT_OF_MEMORY);
  make(static_cast<int>(realBase));
  for (int i = 0; i < count; ++i) {
    auto list = std::make_shared<DisplayList>();
    list->append(std::make_unique<FragmentOp>(realBase + static_cast<GLuint>(i), c.shadow.sharedGroup));
    c.shadow.group.lists.put(static_cast<GLuint>(base + i), std::move(list));
  }
}

}  // namespace gluray::gl
