// Handlers of array draws, and their fates.
#include "gl/commands/array_draws.h"

#include "gl/arrays/array_indices.h"
#include "gl/commands/program_arrays_draw.h"
#include "gl/context/geometry_run.h"
#include "gl/context/handlers.h"
#include "gl/context/stub.h"
#include "gl/real/extensions.h"

#include <memory>

namespace gluray::gl {

void refuse(Context& c, GLenum error) {
  // Inside glBegin, GL_INVALID_OPERATION takes precedence, except while a list is compiled.
  if (c.immediate.insideBegin()) return c.lists.misuse(c.lists.compiling() ? error : GL_INVALID_OPERATION);
  if (!c.lists.compiling()) return c.errors.set(error);
  c.lists.record([error](Context& x) { x.errors.set(error); });
}

bool validate(Context& c, GLenum mode, const Elements& e) {
  if (e.count < 0 || e.instances < -1 || (e.instances >= 0 && e.first < 0))
    return refuse(c, GL_INVALID_VALUE), false;
  if (!isPrimitive(c.shadow.real, mode)) return refuse(c, GL_INVALID_ENUM), false;
  if (e.type && !isIndexType(e.type)) return refuse(c, GL_INVALID_ENUM), false;
  if (c.immediate.insideBegin()) return c.lists.misuse(), false;
  return true;
}

namespace {

constexpr GLsizei kSmall = 192;  // maximum vertices of a draw that joins a run instead of becoming a mesh

/// Records a draw in a list. Its arrays are read now, as display lists demand (GL 2.1, 5.4).
Fate recordDraw(Context& c, GLenum mode, const Elements& e) {
  // Without a position array the draw may use the current position: the real OpenGL decides.
  if (e.instances >= 0 || c.shadow.arrays().others || c.shadow.arrays().reason != Reason::traced ||
      mode > GL_POLYGON || !c.shadow.arrays().vertex.enabled || c.shadow.isRestarted(c.shadow.arrays(), e)) {
    c.shadow.sendBuffers();
    return c.lists.recordFragment([&] { drawReal(c.real, mode, e); }), Fate::recordedBelow;
  }
  if (e.count <= kSmall)
    return c.immediate.drawSmall(mode, vertexNumbers(c.real, c.shadow.arrays(), e), pathOf(e)),
           Fate::joinedRun;
  std::unique_ptr<GeometryRun> op;
  const Reason captured = c.failsafe.attempt([&] {
    CapturedVertices run = capture(c.real, c.shadow.arrays(), mode, e, Fractions::ofCommands);
    if (!run.empty()) op = std::make_unique<GeometryRun>(std::move(run), classOf(mode), c.shadow.sharedGroup);
    if (op && c.lists.continuesMultiDraw()) op->setContinues();
    return Reason::traced;
  });
  std::unique_ptr<ListOp> recorded = std::move(op);
  if (captured == Reason::traced) return c.failsafe.insist([&] { c.lists.append(recorded); }), Fate::recorded;
  c.shadow.sendBuffers();
  c.lists.recordFragment([&] { drawReal(c.real, mode, e); });
  return Fate::recordedBelow;
}

}  // namespace

namespace {

/// Adds a small draw to the open run of vertices, if it can be traced. Returns false if nothing was done.
bool joinsRun(Context& c, GLenum mode, const Elements& e) {
  const bool plain = e.instances < 0 && mode <= GL_POLYGON && c.shadow.arrays().reason == Reason::traced &&
                     c.shadow.arrays().vertex.enabled;
  // The run may be drawn again without indices, and llvmpipe then splits quads along the other diagonal.
  const bool splits = mode == GL_QUADS && e.type;
  if (!plain || splits || e.count > kSmall || c.shadow.isRestarted(c.shadow.arrays(), e) ||
      c.classifier.classify(classOf(mode)) != Reason::traced)
    return false;
  const Reason joined = c.failsafe.attempt([&] {
    c.immediate.drawSmall(mode, vertexNumbers(c.real, c.shadow.arrays(), e), pathOf(e));
    return Reason::traced;
  });
  return joined == Reason::traced;
}

/// Records a draw in the list being compiled.
Fate record(Context& c, GLenum mode, const Elements& e) {
  // Instanced draws are errors in lists, even empty ones.
  if ((e.count == 0 || e.instances == 0) && e.instances < 0) return Fate::empty;
  return recordDraw(c, mode, e);
}

Fate drawByFixedFunction(Context& c, GLenum mode, const Elements& e) {
  c.shadow.refresh(kDrawGroups | kFixedArrays);
  if (joinsRun(c, mode, e)) return Fate::joinedRun;
  c.immediate.closeRunIfOpen();
  c.shadow.refresh(kDrawGroups);  // the run may have set a material
  FixedArraysDraw request(c, mode, e);
  return c.draws.submit(request);
}

Fate drawByProgram(Context& c, GLenum mode, const Elements& e) {
  c.shadow.refresh(kProgramGroups);
  c.immediate.closeRunIfOpen();
  const bool mayBeHeld = !c.shadow.isRestarted(c.shadow.attributes(), e);
  if (mayBeHeld && passOf(c.shadow.program()) == Family::Pass::peelDepths &&
      c.protect([&] { return c.layers.peels.holdDepths(mode, e, trianglesOf(mode, e)); }))
    return Fate::heldPass;
  if (c.layers.later.drawsNothing()) return Fate::leftOutPass;
  if (mayBeHeld && c.layers.held.asks() && c.protect([&] { return c.layers.later.holdLater(mode, e); }))
    return Fate::heldPeel;
  ProgramArraysDraw request(c, mode, e);
  return c.draws.submit(request);
}

Fate draw(Context& c, GLenum mode, const Elements& e) {
  if (!validate(c, mode, e)) return Fate::refused;
  if (e.first < 0) return Fate::undefined;
  if (c.lists.compiling()) return record(c, mode, e);
  if (e.count == 0 || e.instances == 0) return drawReal(c.real, mode, e), Fate::empty;
  const DrawTimer timer(c.counts.kinds());
  if (c.clock.passesThrough()) {
    const DrawRequest::Load load = loadOf(c, mode, e);
    if (c.passthrough.takes(load.path, load.primitive, load.triangles, load.more))
      return drawReal(c.real, mode, e), Fate::passedThrough;
  }
  c.passthrough.works();
  if (drawUntraced(c, mode, e)) return Fate::untraced;
  const bool program = c.shadow.raster().program != 0 || c.info().core;
  return program ? drawByProgram(c, mode, e) : drawByFixedFunction(c, mode, e);
}

}  // namespace

void drawArrays(Context& c, GLenum mode, GLint first, GLsizei count) {
  draw(c, mode, {first, count, 0, nullptr, 0});
}

void drawElements(Context& c, GLenum mode, GLsizei count, GLenum type, const void* indices) {
  if (!isIndexType(type)) return refuse(c, GL_INVALID_ENUM);
  draw(c, mode, {0, count, type, indices, 0});
}

void drawRangeElements(Context& c, GLenum mode, GLuint start, GLuint end, GLsizei count, GLenum type,
                       const void* indices) {
  if (end < start) return refuse(c, GL_INVALID_VALUE);
  drawElements(c, mode, count, type, indices);
}

void drawElementsBaseVertex(Context& c, GLenum mode, GLsizei count, GLenum type, const void* indices,
                            GLint base) {
  if (!isIndexType(type)) return refuse(c, GL_INVALID_ENUM);
  draw(c, mode, {0, count, type, indices, base});
}

void drawRangeElementsBaseVertex(Context& c, GLenum mode, GLuint start, GLuint end, GLsizei count,
                                 GLenum type, const void* indices, GLint base) {
  if (end < start) return refuse(c, GL_INVALID_VALUE);
  drawElementsBaseVertex(c, mode, count, type, indices, base);
}

void drawArraysInstanced(Context& c, GLenum mode, GLint first, GLsizei count, GLsizei instances) {
  drawArraysInstancedBaseInstance(c, mode, first, count, instances, 0);
}

void drawArraysInstancedBaseInstance(Context& c, GLenum mode, GLint first, GLsizei count, GLsizei instances,
                                     GLuint baseInstance) {
  if (instances < 0) return refuse(c, GL_INVALID_VALUE);
  draw(c, mode, {first, count, 0, nullptr, 0, instances, baseInstance});
}

void drawElementsInstanced(Context& c, GLenum mode, GLsizei count, GLenum type, const void* indices,
                           GLsizei instances) {
  drawElementsInstancedBaseVertexBaseInstance(c, mode, count, type, indices, instances, 0, 0);
}

void drawElementsInstancedBaseVertex(Context& c, GLenum mode, GLsizei count, GLenum type, const void* indices,
                                     GLsizei instances, GLint base) {
  drawElementsInstancedBaseVertexBaseInstance(c, mode, count, type, indices, instances, base, 0);
}

void drawElementsInstancedBaseInstance(Context& c, GLenum mode, GLsizei count, GLenum type,
                                       const void* indices, GLsizei instances, GLuint baseInstance) {
  drawElementsInstancedBaseVertexBaseInstance(c, mode, count, type, indices, instances, 0, baseInstance);
}

void drawElementsInstancedBaseVertexBaseInstance(Context& c, GLenum mode, GLsizei count, GLenum type,
                                                 const void* indices, GLsizei instances, GLint base,
                                                 GLuint baseInstance) {
  if (!isIndexType(type)) return refuse(c, GL_INVALID_ENUM);
  if (instances < 0) return refuse(c, GL_INVALID_VALUE);
  draw(c, mode, {0, count, type, indices, base, instances, baseInstance});
}

}  // namespace gluray::gl
