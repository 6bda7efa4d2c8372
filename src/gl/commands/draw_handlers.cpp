// Handlers of glBegin, glEnd, glMaterial, glRect and glArrayElement; small draws from vertex arrays.
#include "base/clock.h"
#include "gl/capture/vertex_attribute_calls.h"
#include "gl/context/handlers.h"
#include "gl/context/stub.h"

#include <algorithm>
#include <cstring>
#include <span>

namespace gluray::gl {

void begin(Context& c, GLenum mode) {
  c.failsafe.insist([&] { c.immediate.begin(mode); });
}
void end(Context& c) { c.immediate.end(); }

void materialfv(Context& c, GLenum face, GLenum pname, const GLfloat* params) {
  c.immediate.material(face, pname, params);
}

namespace {
/// Sends a call to the real OpenGL: now, or as a fragment of the list being compiled.
template <class F>
void unmodelled(Context& c, F&& call) {
  if (!c.lists.compiling()) return call();
  if (c.immediate.insideBegin()) return c.lists.misuse(GL_INVALID_ENUM);
  c.lists.recordFragment(call);
}
}  // namespace

void materialf(Context& c, GLenum face, GLenum pname, GLfloat param) {
  // For a single value, the specification demands an error, and Mesa makes a vector of it. The real OpenGL
  // decides. Inside a list's primitive it cannot, so GLuRay does as Mesa does.
  const GLfloat values[4] = {param, 0, 0, 0};
  if (pname != GL_SHININESS && c.lists.compiling() && c.immediate.insideBegin())
    return c.immediate.material(face, pname, values);
  if (pname != GL_SHININESS) return unmodelled(c, [&] { c.real.Materialf(face, pname, param); });
  c.immediate.material(face, pname, &param);
}

void materiali(Context& c, GLenum face, GLenum pname, GLint param) {
  materialf(c, face, pname, static_cast<GLfloat>(param));
}

void materialiv(Context& c, GLenum face, GLenum pname, const GLint* params) {
  if (pname == GL_COLOR_INDEXES) return unmodelled(c, [&] { c.real.Materialiv(face, pname, params); });
  GLfloat values[4] = {};
  for (size_t i = 0; i < materialParams(pname); ++i)  // colours map linearly, GL 2.1 table 2.9
    values[i] = pname == GL_SHININESS ? static_cast<GLfloat>(params[i])
                                      : static_cast<GLfloat>((2.0 * params[i] + 1.0) / 4294967295.0);
  c.immediate.material(face, pname, values);
}

void rectf(Context& c, GLfloat x1, GLfloat y1, GLfloat x2, GLfloat y2) {
  if (c.immediate.insideBegin()) return c.lists.misuse();
  // Differs: GL 2.1, 2.10 says a polygon. Mesa draws a quad, which is split along the other diagonal.
  // Interpolated values depend on that in their last bits.
  c.immediate.begin(GL_QUADS);
  vertexcall::vertex(x1, y1), vertexcall::vertex(x2, y1), vertexcall::vertex(x2, y2),
      vertexcall::vertex(x1, y2);
  c.immediate.end();
}
namespace {
template <class T>
void rect(Context& c, T x1, T y1, T x2, T y2) {
  rectf(c, static_cast<GLfloat>(x1), static_cast<GLfloat>(y1), static_cast<GLfloat>(x2),
        static_cast<GLfloat>(y2));
}
}  // namespace
void rectd(Context& c, GLdouble x1, GLdouble y1, GLdouble x2, GLdouble y2) { rect(c, x1, y1, x2, y2); }
void recti(Context& c, GLint x1, GLint y1, GLint x2, GLint y2) { rect(c, x1, y1, x2, y2); }
void rects(Context& c, GLshort x1, GLshort y1, GLshort x2, GLshort y2) { rect(c, x1, y1, x2, y2); }
void rectfv(Context& c, const GLfloat* a, const GLfloat* b) { rect(c, a[0], a[1], b[0], b[1]); }
void rectdv(Context& c, const GLdouble* a, const GLdouble* b) { rect(c, a[0], a[1], b[0], b[1]); }
void rectiv(Context& c, const GLint* a, const GLint* b) { rect(c, a[0], a[1], b[0], b[1]); }
void rectsv(Context& c, const GLshort* a, const GLshort* b) { rect(c, a[0], a[1], b[0], b[1]); }

namespace {

/// Sends single vertices of the enabled arrays through attribute calls.
class ElementSender {
 public:
  ElementSender(const RealGl& real, const ArrayState& arrays, Fractions fractions)
      : normal_(real, arrays.normal, fractions),
        color_(real, arrays.color, fractions),
        secondaryColor_(real, arrays.secondaryColor, fractions),
        fogCoord_(real, arrays.fogCoord, fractions),
        texcoord_(real, arrays.texcoord, fractions),
        vertex_(real, arrays.vertex, fractions) {
    for (const ArraySource& source : arrays.texcoordsAbove)
      texcoordsAbove_.emplace_back(real, source, fractions);
  }

  void operator()(uint32_t i) const {
    float v[4];
    if (read(normal_, i, v)) vertexcall::normal(v[0], v[1], v[2]);
    if (read(color_, i, v)) vertexcall::color(v[0], v[1], v[2], v[3]);
    if (read(secondaryColor_, i, v)) vertexcall::secondaryColor(v[0], v[1], v[2]);
    if (read(fogCoord_, i, v)) vertexcall::fogCoord(v[0]);
    if (read(texcoord_, i, v)) vertexcall::texCoord(0, v[0], v[1], v[2], v[3]);
    for (GLuint unit = 1; unit <= texcoordsAbove_.size(); ++unit)
      if (read(texcoordsAbove_[unit - 1], i, v)) vertexcall::texCoord(unit, v[0], v[1], v[2], v[3]);
    if (read(vertex_, i, v)) vertexcall::vertex(v[0], v[1], v[2], v[3]);
  }

 private:
  static bool read(const ArrayReader& reader, uint32_t i, float* v) {
    if (i >= reader.available()) return false;
    reader.read(i, v);
    return true;
  }
  ArrayReader normal_, color_, secondaryColor_, fogCoord_, texcoord_, vertex_;
  std::vector<ArrayReader> texcoordsAbove_;
};

}  // namespace

void arrayElement(Context& c, GLint i) {
  if (c.immediate.inside() == Immediate::Inside::rasterised) return c.immediate.rasterElement(i);
  if (c.clock.passesThrough() && !c.lists.compiling()) {
    c.shadow.sendBuffers();
    return c.real.ArrayElement(i);
  }
  // GLuRay does not read these arrays: the real OpenGL takes over the primitive.
  const ArrayState& arrays = c.shadow.arrays();
  if (arrays.others || arrays.restart.isOn() || arrays.reason != Reason::traced) {
    if (!c.immediate.insideBegin() && c.lists.compiling()) {
      c.shadow.sendBuffers();
      return c.lists.recordFragment([&] { c.real.ArrayElement(i); });
    }
    c.immediate.closeRunOutsideBegin();
    c.beforeForward(Context::Flush::none);
    if (c.immediate.insideBegin()) return c.immediate.rasterElement(i);
    c.shadow.sendBuffers();
    c.shadow.touch(kCurrent);
    return c.real.ArrayElement(i);
  }
  const ElementSender send(c.real, arrays, Fractions::ofCommands);
  send(static_cast<uint32_t>(i));
}

void Immediate::drawSmall(GLenum mode, const std::vector<uint32_t>& vertices, DrawPath path) {
  // Array draws leave the current attributes unchanged.
  const SlotMask slots = slotsOf(p_.shadow.arrays()) & ~bit(kPosition);
  SlotValues before = p_.shadow.current.all();
  for (int s = kNormal; s < kSlotCount; ++s)
    if (slots & bit(static_cast<Slot>(s)))
      std::memcpy(before[static_cast<size_t>(s)].data(), current(static_cast<Slot>(s)),
                  sizeOf(static_cast<Slot>(s)) * 4);
  const bool recorded = p_.lists.compiling();
  begin(mode, !recorded);
  if (!recorded)
    open_ ? p_.shadow.current.drawnLater(p_.shadow.real) : p_.shadow.current.drawn(p_.shadow.real);
  if (stream_.empty()) path_ = path;
  const ElementSender send(p_.shadow.real, p_.shadow.arrays(),
                           recorded ? Fractions::ofCommands : Fractions::ofArrays);
  for (const uint32_t i : vertices) send(i);
  end();
  for (int s = kNormal; s < kSlotCount; ++s) {
    const auto slot = static_cast<Slot>(s);
    if (!(slots & bit(slot))) continue;
    if ((recorded || open_) && stream_.has(slot))
      stream_.set(slot, before[slot].data());
    else
      attribute(slot, before[slot].data());
  }
  // The next attribute must not bypass attribute().
  if (recorded) listValues_.fromArrays(stream_), ofArrays_ = true, t_thread.stream = nullptr;
}

}  // namespace gluray::gl
