// Handlers of multi-draws: several draws of the same arrays by one command.
#include "gl/commands/array_draws.h"
#include "gl/context/handlers.h"

#include <algorithm>

namespace gluray::gl {
namespace {

/// Checks the mode even if there are no draws.
bool isValid(Context& c, GLenum mode, const GLsizei* count, GLsizei draws) {
  if (draws < 0 || std::any_of(count, count + draws, [](GLsizei n) { return n < 0; }))
    return refuse(c, GL_INVALID_VALUE), false;
  return validate(c, mode, Elements{});
}

/// Whether the real OpenGL makes all the draws unchanged. If so, they are counted as one draw, and its own
/// multi-draw may be called. `elementsOf`: returns a draw by its number.
template <class ElementsOf>
bool takesTogether(Context& c, GLenum mode, GLsizei draws, const ElementsOf& elementsOf) {
  if (c.lists.compiling() || draws < 2) return false;
  uint64_t triangles = 0;
  for (GLsizei i = 0; i < draws; ++i) {
    const Elements e = elementsOf(i);
    if (e.first < 0) return false;
    triangles += trianglesOf(mode, e);
  }
  const auto mayCullAny = [&] {
    for (GLsizei i = 0; i < draws; ++i)
      if (c.culled.mayLeaveOut(elementsOf(i)) != CulledDraws::Part::nothing) return true;
    return false;
  };
  const DrawPath path = pathOf(elementsOf(0));
  if (c.clock.passesThrough() && c.passthrough.takes(path, kindOf(mode), triangles)) return true;
  c.passthrough.works();
  if (c.protect([&] { return c.untraced.numbersDraws(); }))
    c.beforeForward(Context::Flush::all);
  else if (!drawsUntraced(c) || mayCullAny())
    return false;
  beforeUntraced(c, mode, path, triangles);
  for (GLsizei i = 0; i < draws; ++i) {
    const Elements e = elementsOf(i);
    c.culled.count(e);
    rememberUntraced(c, mode, e);
  }
  return true;
}

/// While it lives, draws that are compiled into a list are later ones of a multi-draw.
class Continuing {
 public:
  explicit Continuing(ListCompiler& lists) : lists_(lists) { lists_.continueMultiDraw(true); }
  ~Continuing() { lists_.continueMultiDraw(false); }
  Continuing(const Continuing&) = delete;
  Continuing& operator=(const Continuing&) = delete;

 private:
  ListCompiler& lists_;
};

/// Calls draw(i) for each draw. Together they store the current values once.
template <class Draw>
void drawEach(Context& c, GLsizei draws, const Draw& draw) {
  if (draws < 1) return;
  draw(0);
  if (c.lists.compiling()) {
    const Continuing continuing(c.lists);
    for (GLsizei i = 1; i < draws; ++i) draw(i);
    return;
  }
  const CurrentValues::Held after = c.shadow.current.held();
  c.shadow.current.letGo();
  const uint64_t rasterised = c.counts.statistics.drawsRasterised;
  for (GLsizei i = 1; i < draws; ++i) draw(i);
  c.shadow.current.holdAgain(after);
  if (c.counts.statistics.drawsRasterised != rasterised) c.shadow.current.restore(c.real);
}

}  // namespace

void multiDrawArrays(Context& c, GLenum mode, const GLint* first, const GLsizei* count, GLsizei draws) {
  if (!isValid(c, mode, count, draws)) return;
  const auto elementsOf = [&](GLsizei i) { return Elements{first[i], count[i], 0, nullptr, 0}; };
  if (takesTogether(c, mode, draws, elementsOf)) return c.real.MultiDrawArrays(mode, first, count, draws);
  drawEach(c, draws, [&](GLsizei i) { drawArrays(c, mode, first[i], count[i]); });
}

void multiDrawElements(Context& c, GLenum mode, const GLsizei* count, GLenum type, const void* const* indices,
                       GLsizei draws) {
  if (!isIndexType(type)) return refuse(c, GL_INVALID_ENUM);
  if (!isValid(c, mode, count, draws)) return;
  const auto elementsOf = [&](GLsizei i) { return Elements{0, count[i], type, indices[i], 0}; };
  if (takesTogether(c, mode, draws, elementsOf))
    return c.real.MultiDrawElements(mode, count, type, indices, draws);
  drawEach(c, draws, [&](GLsizei i) { drawElements(c, mode, count[i], type, indices[i]); });
}

void multiDrawElementsBaseVertex(Context& c, GLenum mode, const GLsizei* count, GLenum type,
                                 const void* const* indices, GLsizei draws, const GLint* base) {
  if (!isIndexType(type)) return refuse(c, GL_INVALID_ENUM);
  if (!isValid(c, mode, count, draws)) return;
  const auto elementsOf = [&](GLsizei i) { return Elements{0, count[i], type, indices[i], base[i]}; };
  if (takesTogether(c, mode, draws, elementsOf))
    return c.real.MultiDrawElementsBaseVertex(mode, count, type, indices, draws, base);
  drawEach(c, draws,
           [&](GLsizei i) { drawElementsBaseVertex(c, mode, count[i], type, indices[i], base[i]); });
}

}  // namespace gluray::gl
