// Handlers of clears, glFlush, glFinish, fences, the attribute stack, queries, and changes of textures and
// programs.
#include "gl/context/handlers.h"
#include "gl/context/stub.h"
#include "gl/real/hidden_extensions.h"
#include "gl/real/state_queries.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace gluray::gl {
namespace {

/// Whether glClear raises an error, unless an extension defines the bits. An erroneous glClear clears
/// nothing.
bool isRefused(const Context& c, GLbitfield mask) {
  return mask & ~(kClears | (c.info().core ? 0u : GLbitfield{GL_ACCUM_BUFFER_BIT}));
}

void clearNow(Context& c, GLbitfield mask) {
  if (isRefused(c, mask)) return c.beforeForward(Context::Flush::all), c.real.Clear(mask);
  c.frames.beforeClear(mask);
  c.shadow.current.changeState(c.real);
  c.layers.peels.clearing();
  if (c.layers.later.clearsLater(mask)) return;
  bool later = false;
  c.protect([&] { later = c.window.clearsLater(mask); });
  const UnresolvedImage::Cleared clean = later ? UnresolvedImage::Cleared{} : c.flusher.beforeClear(mask);
  if (mask & GL_STENCIL_BUFFER_BIT) stencilSet(c);
  c.frames.clearing(mask);
  if (!later) c.real.Clear(mask);
  c.frames.cleared(mask);
  c.resolves.cleanIs(c.clock.passesThrough() ? UnresolvedImage::Cleared{} : clean);
}

}  // namespace

void clear(Context& c, GLbitfield mask) {
  if (c.lists.compiling()) return c.lists.record([mask](Context& x) { clearNow(x, mask); });
  clearNow(c, mask);
}

void flush(Context& c) {
  c.frames.showIfVisible();
  c.shadow.textures.finished();
  c.real.Flush();
}

void finish(Context& c) {
  c.protect([&] {
    c.window.showLagged();
    if (c.layers.held.holdsBack()) c.flusher.flush();
  });
  c.frames.finish();
  c.shadow.textures.finished();
  c.real.Finish();
}

/// A fence signals after all earlier draws (OpenGL 4.6, 4.1.2). Contexts that wait for it see only shared
/// objects: the images of framebuffer objects. A fence does not end a frame.
void fenceSync(Context& c, GLenum, GLbitfield) {
  if (c.shadow.group.contexts == 1) return;
  const Batch& batch = c.pending.batch;
  const bool isPending = !batch.empty() && batch.key().framebuffer != 0;
  if (isPending || c.layers.held.holdsBack())
    c.flusher.flush();
  else if (c.resolves.waits())
    c.flusher.settle();
  c.shadow.textures.finished();
}

void pushAttrib(Context& c, GLbitfield mask) {
  if (c.lists.compiling()) return c.lists.record([mask](Context& x) { x.attribStack.push(mask); });
  c.attribStack.push(mask);
}

void popAttrib(Context& c) {
  if (c.lists.compiling()) return c.lists.record([](Context& x) { x.attribStack.pop(); });
  c.attribStack.pop();
}

GLenum getError(Context& c) {
  const bool compiledOnly = c.lists.compiling() && !c.lists.executing();
  const bool inside = c.immediate.insideBegin() || c.immediate.executedInside();
  if (inside && !compiledOnly) return c.errors.set(GL_INVALID_OPERATION), GLenum{GL_NO_ERROR};
  return c.errors.takeError();
}

namespace {

bool hides(const Context& c) { return c.shadow.settings.quirks.has(Quirk::hidePersistentMapping); }

/// Answers queries of our display lists, and of GL_NUM_EXTENSIONS if some are hidden. Returns false for all
/// others.
template <class T>
bool answer(Context& c, GLenum pname, T* data) {
  GLuint value = 0;
  switch (pname) {
    case GL_LIST_BASE: value = c.lists.base; break;
    case GL_LIST_INDEX: value = c.lists.name(); break;
    case GL_LIST_MODE: value = c.lists.mode(); break;
    case GL_NUM_EXTENSIONS:
      if (!hides(c)) return false;
      value = static_cast<GLuint>(visibleExtensions(c.real));
      break;
    default: return false;
  }
  if constexpr (std::is_same_v<T, GLboolean>)
    *data = value ? GL_TRUE : GL_FALSE;
  else
    *data = static_cast<T>(value);
  return true;
}

}  // namespace

const GLubyte* getString(Context& c, GLenum name) {
  const GLubyte* text = c.real.GetString(name);
  return name == GL_EXTENSIONS && hides(c) ? withoutHidden(text) : text;
}

const GLubyte* getStringi(Context& c, GLenum name, GLuint index) {
  if (name == GL_EXTENSIONS && hides(c)) index = realExtensionIndex(c.real, index);
  return c.real.GetStringi(name, index);
}

void getIntegerv(Context& c, GLenum pname, GLint* data) {
  if (answer(c, pname, data)) return;
  c.real.GetIntegerv(pname, data);
  noteCurrentValueQuery(c, pname);
}

void getFloatv(Context& c, GLenum pname, GLfloat* data) {
  if (answer(c, pname, data)) return;
  c.real.GetFloatv(pname, data);
  noteCurrentValueQuery(c, pname);
}

void getDoublev(Context& c, GLenum pname, GLdouble* data) {
  if (answer(c, pname, data)) return;
  c.real.GetDoublev(pname, data);
  noteCurrentValueQuery(c, pname);
}

void getBooleanv(Context& c, GLenum pname, GLboolean* data) {
  if (answer(c, pname, data)) return;
  c.real.GetBooleanv(pname, data);
  noteCurrentValueQuery(c, pname);
}

void getInteger64v(Context& c, GLenum pname, GLint64* data) {
  if (answer(c, pname, data)) return;
  c.real.GetInteger64v(pname, data);
  noteCurrentValueQuery(c, pname);
}

namespace {

/// Whether a query object observes draws; timers and time stamps do not.
bool countsDraws(GLenum target) { return target != GL_TIME_ELAPSED && target != GL_TIMESTAMP; }

void endGuard(Context& c) { c.shadow.activeQueries = std::max(0, c.shadow.activeQueries - 1); }

}  // namespace

void beginQuery(Context& c, GLenum target, GLuint id) {
  if (!countsDraws(target)) return;
  if (c.layers.held.pending()) c.protect([&] { c.layers.later.queryBegins(target, id); });
  ++c.shadow.activeQueries;
}
void beginQueryIndexed(Context& c, GLenum target, GLuint, GLuint id) { beginQuery(c, target, id); }
void endQuery(Context& c, GLenum target) {
  if (countsDraws(target)) endGuard(c);
}
void endQueryIndexed(Context& c, GLenum target, GLuint) { endQuery(c, target); }
void beginConditionalRender(Context& c, GLuint, GLenum) { ++c.shadow.activeQueries; }
void endConditionalRender(Context& c) { endGuard(c); }

void matrixMode(Context& c, GLenum mode) {
  c.shadow.current.stateChanges();
  c.shadow.matrixMode = mode;
}

uint32_t matrixGroups(Context& c) {
  if (c.shadow.matrixMode == 0) {
    GLint mode = GL_MODELVIEW;
    c.real.GetIntegerv(GL_MATRIX_MODE, &mode);
    c.shadow.matrixMode = static_cast<GLenum>(mode);
  }
  switch (c.shadow.matrixMode) {
    case GL_MODELVIEW: return kModelview;
    case GL_PROJECTION: return kProjection;
    case GL_TEXTURE: return kTexture;
    default: return kModelview | kProjection | kTexture;  // the program set an invalid mode
  }
}

uint32_t textureAttached(Context& c, GLuint texture) {
  c.cleared.forget();
  c.shadow.textures.attached(texture);
  return kTarget | kTexture;
}

Context::Flush flushToBind(Context& c, GLenum target, GLuint framebuffer) {
  const auto isBound = [&](GLenum binding) {
    return static_cast<GLuint>(integer(c.real, binding)) == framebuffer;
  };
  const bool draws = target != GL_READ_FRAMEBUFFER, reads = target != GL_DRAW_FRAMEBUFFER;
  const bool bound = c.shadow.rare().framebufferObjects && (!draws || isBound(GL_DRAW_FRAMEBUFFER_BINDING)) &&
                     (!reads || isBound(GL_READ_FRAMEBUFFER_BINDING));
  return bound ? Context::Flush::none : Context::Flush::leave;
}

Context::Flush flushToRead(GLenum format) {
  const bool colors =
      format != GL_DEPTH_COMPONENT && format != GL_STENCIL_INDEX && format != GL_DEPTH_STENCIL;
  return colors ? Context::Flush::read : Context::Flush::look;
}

uint32_t framebufferBound(Context& c) {
  c.shadow.textures.framebufferBound(c.real);
  return kTarget | kTexture;
}

uint32_t imageChanged(Context& c, GLenum target) {
  c.cleared.imageSent(target);
  c.flusher.imagesChange();
  c.shadow.textures.imageChanged(c.real, target);
  return kTexture;
}

uint32_t imageCopied(Context& c, GLenum target, GLint level, glm::ivec2 offset, const scene::Region& from) {
  const uint32_t groups = imageChanged(c, target);
  c.cleared.imageCopied(target, level, offset, from);
  return groups;
}

uint32_t texturesDeleted(Context& c, GLsizei n, const GLuint* names) {
  c.cleared.forget();
  c.flusher.imagesChange();
  for (GLsizei i = 0; names && i < n; ++i) c.shadow.textures.deleted(names[i]);
  return kTexture | imagesDeleted(c, GL_TEXTURE, n, names);
}

uint32_t stencilSet(Context& c) {
  c.shadow.group.stencilsSet = true;
  return 0;
}

uint32_t stencilSent(Context& c, GLenum format, const void* pixels) {
  if (format != GL_DEPTH_STENCIL && format != GL_STENCIL_INDEX) return 0;
  return pixels || integer(c.real, GL_PIXEL_UNPACK_BUFFER_BINDING) != 0 ? stencilSet(c) : 0;
}

uint32_t imagesChanged(Context& c) {
  c.cleared.forget();
  stencilSet(c);
  c.flusher.imagesChange();
  c.shadow.textures.allImagesChanged();
  return kTexture;
}

uint32_t programChanged(Context& c, GLuint program) {
  c.layers.peels.programChanges(program);
  c.protect([&] { c.shadow.group.programChanged(program); });
  return kRaster | kProgram | kAttributes;
}

uint32_t programDeleted(Context& c, GLuint program) {
  c.layers.peels.programChanges(program);
  c.shadow.group.programDeleted(program);
  return kRaster | kProgram | kAttributes;
}

uint32_t programLinked(Context& c, GLuint program) {
  const uint32_t changed = programChanged(c, program);
  if (isPresent(c.real.IsProgram) && c.real.IsProgram(program))
    c.protect([&] { c.shadow.group.programLinked(c.real, program); });
  return changed;
}

}  // namespace gluray::gl
