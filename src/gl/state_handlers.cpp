// Clears and finishes, the attribute stack, questions.
#include "gl/handlers.h"
#include "gl/stub.h"

#include <glm/gtc/type_ptr.hpp>

namespace gluray::gl {
namespace {

/// The colour of a clear that leaves nothing of the framebuffer, with depth 1; nothing for any lesser clear.
std::optional<glm::vec4> wholeClear(const RealGl& real, GLbitfield mask) {
  if (!(mask & GL_COLOR_BUFFER_BIT) || !(mask & GL_DEPTH_BUFFER_BIT) || real.IsEnabled(GL_SCISSOR_TEST))
    return {};
  GLboolean colors[4] = {}, depth = GL_FALSE;
  real.GetBooleanv(GL_COLOR_WRITEMASK, colors);
  real.GetBooleanv(GL_DEPTH_WRITEMASK, &depth);
  GLfloat clearDepth = 0;
  real.GetFloatv(GL_DEPTH_CLEAR_VALUE, &clearDepth);
  if (!colors[0] || !colors[1] || !colors[2] || !colors[3] || !depth || clearDepth != 1.0f) return {};
  glm::vec4 color(0);
  real.GetFloatv(GL_COLOR_CLEAR_VALUE, glm::value_ptr(color));
  return color;
}

void clearNow(Context& c, GLbitfield mask) {
  c.syncCurrent();
  c.flush();
  c.real.Clear(mask);
  c.setCleared(wholeClear(c.real, mask));
}

}  // namespace

void clear(Context& c, GLbitfield mask) {
  if (c.compiling()) return c.record([mask](Context& x) { clearNow(x, mask); });
  clearNow(c, mask);
}

void flush(Context& c) {
  c.showIfVisible();
  c.real.Flush();
}

void finish(Context& c) {
  c.showIfVisible();
  c.real.Finish();
}

void pushAttrib(Context& c, GLbitfield mask) {
  if (c.compiling()) return c.record([mask](Context& x) { x.pushAttrib(mask); });
  c.pushAttrib(mask);
}

void popAttrib(Context& c) {
  if (c.compiling()) return c.record([](Context& x) { x.popAttrib(); });
  c.popAttrib();
}

GLenum getError(Context& c) {
  if (c.insideBegin()) return c.setError(GL_INVALID_OPERATION), GLenum{GL_NO_ERROR};
  return c.takeError();
}

namespace {

/// The answers of display lists, which the real OpenGL does not know. False for any other question.
template <class T>
bool answer(Context& c, GLenum pname, T* data) {
  GLuint value = 0;
  switch (pname) {
    case GL_LIST_BASE: value = c.listBase; break;
    case GL_LIST_INDEX: value = c.listName(); break;
    case GL_LIST_MODE: value = c.listMode(); break;
    default: return false;
  }
  if constexpr (std::is_same_v<T, GLboolean>)
    *data = value ? GL_TRUE : GL_FALSE;
  else
    *data = static_cast<T>(value);
  return true;
}

}  // namespace

void getIntegerv(Context& c, GLenum pname, GLint* data) {
  if (answer(c, pname, data)) return;
  c.syncCurrent();
  c.real.GetIntegerv(pname, data);
}

void getFloatv(Context& c, GLenum pname, GLfloat* data) {
  if (answer(c, pname, data)) return;
  c.syncCurrent();
  c.real.GetFloatv(pname, data);
}

void getDoublev(Context& c, GLenum pname, GLdouble* data) {
  if (answer(c, pname, data)) return;
  c.syncCurrent();
  c.real.GetDoublev(pname, data);
}

void getBooleanv(Context& c, GLenum pname, GLboolean* data) {
  if (answer(c, pname, data)) return;
  c.syncCurrent();
  c.real.GetBooleanv(pname, data);
}

void getInteger64v(Context& c, GLenum pname, GLint64* data) {
  if (answer(c, pname, data)) return;
  c.syncCurrent();
  c.real.GetInteger64v(pname, data);
}

void matrixMode(Context& c, GLenum mode) { c.matrixMode = mode; }

uint32_t matrixGroups(Context& c) {
  if (c.matrixMode == 0) {
    GLint mode = GL_MODELVIEW;
    c.real.GetIntegerv(GL_MATRIX_MODE, &mode);
    c.matrixMode = static_cast<GLenum>(mode);
  }
  switch (c.matrixMode) {
    case GL_MODELVIEW: return kModelview;
    case GL_PROJECTION: return kProjection;
    case GL_TEXTURE: return kTexture;
    default: return kModelview | kProjection | kTexture;  // the program set a mode that does not exist
  }
}

uint32_t imagesChanged(Context& c) {
  c.textures().allImagesChanged();
  return kTexture;
}

}  // namespace gluray::gl
