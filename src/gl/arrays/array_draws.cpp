// Draws from vertex arrays, by fixed function and by shader programs.
#include "gl/arrays/array_draws.h"

#include "base/clock.h"
#include "base/timeline.h"
#include "gl/arrays/array_indices.h"
#include "gl/capture/vertex_attribute_calls.h"
#include "gl/handlers.h"
#include "gl/lists/geometry_run.h"
#include "gl/stub.h"

#include <algorithm>
#include <cstring>
#include <span>

namespace gluray::gl {
namespace {

bool isMode(GLenum mode) { return mode <= GL_POLYGON || (mode >= GL_LINES_ADJACENCY && mode <= GL_PATCHES); }

bool isIndexType(GLenum type) {
  return type == GL_UNSIGNED_BYTE || type == GL_UNSIGNED_SHORT || type == GL_UNSIGNED_INT;
}

/// The error of a wrong draw: of now or, where a list takes the draw, of the moment when that is called.
void refuse(Context& c, GLenum error) {
  // Inside glBegin that is the first error, but where lists are compiled.
  if (c.immediate.insideBegin()) return c.lists.misuse(c.lists.compiling() ? error : GL_INVALID_OPERATION);
  if (!c.lists.compiling()) return c.errors.set(error);
  c.lists.record([error](Context& x) { x.errors.set(error); });
}

/// Refuses a wrong draw; true where it is none.
bool validate(Context& c, GLenum mode, const Elements& e) {
  if (e.count < 0 || e.instances < -1) return refuse(c, GL_INVALID_VALUE), false;
  if (!isMode(mode)) return refuse(c, GL_INVALID_ENUM), false;
  if (e.type && !isIndexType(e.type)) return refuse(c, GL_INVALID_ENUM), false;
  if (c.immediate.insideBegin()) return c.lists.misuse(), false;
  return true;
}

constexpr GLsizei kSmall = 192;  // vertices: below, draws join a run instead of becoming meshes of their own

/// Records a draw: dereferenced now, as display lists demand (GL 2.1, 5.4).
void recordDraw(Context& c, GLenum mode, const Elements& e) {
  c.shadow.refresh(kFixedArrays);
  // Without positions it may draw at the current one: the real OpenGL knows.
  if (e.instances >= 0 || c.shadow.arrays.others || c.shadow.arrays.reason != Reason::traced ||
      mode > GL_POLYGON || !c.shadow.arrays.vertex.enabled) {
    c.shadow.sendBuffers();
    return c.lists.recordFragment([&] { drawReal(c.real, mode, e); });
  }
  if (e.count <= kSmall)
    return c.immediate.drawSmall(mode, vertexNumbers(c.real, c.shadow.arrays, e), pathOf(e));
  std::unique_ptr<ListOp> op;
  const Reason captured = c.failsafe.attempt([&] {
    CapturedVertices run = capture(c.real, c.shadow.arrays, mode, e);
    if (!run.empty()) op = std::make_unique<GeometryRun>(std::move(run), classOf(mode), c.shadow.sharedGroup);
    return Reason::traced;
  });
  if (captured == Reason::traced) return c.failsafe.insist([&] { c.lists.append(op); });
  c.shadow.sendBuffers();
  c.lists.recordFragment([&] { drawReal(c.real, mode, e); });
}

/// Traces the draw if that can be right; says why not otherwise.
Reason traceDraw(Context& c, GLenum mode, const Elements& e) {
  if (mode > GL_POLYGON) return Reason::program;  // adjacency and patches need shaders
  Reason reason = c.triage.of(classOf(mode));
  if (reason == Reason::traced) reason = c.shadow.arrays.reason;
  if (reason != Reason::traced) return reason;
  return c.failsafe.attempt([&] {
    const KnownMesh known = meshOf(c, c.shadow.arrays, mode, e);
    const Reason fine = c.triage.of(known, {});
    if (fine != Reason::traced) return fine;
    c.filler.add(known.mesh, slotsOf(c.shadow.arrays), {});
    c.counts.traced(pathOf(e), known.mesh->triangleCount);
    return fine;
  });
}

void draw(Context& c, GLenum mode, const Elements& e) {
  if (!validate(c, mode, e) || e.first < 0) return;  // what lies before an array is nobody's
  // Nothing to draw, but an error where nothing could be drawn.
  const bool empty = e.count == 0 || e.instances == 0;
  // Instanced draws are errors in lists, empty ones too.
  if (c.lists.compiling()) return empty && e.instances < 0 ? void() : recordDraw(c, mode, e);
  if (empty) return drawReal(c.real, mode, e);
  const DrawTimer timer(c.counts.kinds());
  if (c.clock.passesThrough()) {
    const Load load = loadOf(c, mode, e);
    if (c.passthrough.takes(pathOf(e), load.kind, load.triangles)) return drawReal(c.real, mode, e);
  }
  c.passthrough.works();
  c.shadow.refresh(kRaster);
  if (c.shadow.state.raster.program != 0 || c.info().core) return drawByProgram(c, mode, e);
  c.shadow.refresh(kDrawGroups | kFixedArrays);
  const bool plain = e.instances < 0 && mode <= GL_POLYGON && c.shadow.arrays.reason == Reason::traced &&
                     c.shadow.arrays.vertex.enabled;
  if (plain && e.count <= kSmall && c.triage.of(classOf(mode)) == Reason::traced) {
    const Reason joined = c.failsafe.attempt([&] {
      c.immediate.drawSmall(mode, vertexNumbers(c.real, c.shadow.arrays, e), pathOf(e));
      return Reason::traced;
    });
    if (joined == Reason::traced) return;
  }
  c.immediate.closeRunIfOpen();
  // Without positions it may draw at the current one: the real OpenGL knows.
  const bool known = c.shadow.arrays.vertex.enabled && e.instances < 0;
  const Reason reason = known ? traceDraw(c, mode, e) : Reason::arrayState;
  if (reason == Reason::traced) return;
  const PrimitiveClass kind = kindOf(mode);
  if (c.shadow.arrays.vertex.enabled && c.shadow.arrays.reason == Reason::traced && c.raster.mayMeet(kind))
    c.protect([&] { c.raster.meet(sampleTriangles(c.real, c.shadow.arrays, mode, e)); });
  if (c.shadow.arrays.vertex.enabled && c.shadow.arrays.reason == Reason::traced &&
      c.raster.isPass(kind, reason))
    c.protect([&] { c.raster.remember(meshOf(c, c.shadow.arrays, mode, e)); });
  c.counts.rasterised(reason, pathOf(e), kind, countTriangles(mode, static_cast<uint64_t>(e.count)));
  c.raster.before(kind);
  c.shadow.sendBuffers();
  drawReal(c.real, mode, e);
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

namespace {

/// Refuses many draws at once where one of them is wrong, or would be if there were any; true where none is.
bool validate(Context& c, GLenum mode, const GLsizei* count, GLsizei draws) {
  if (draws < 0 || std::any_of(count, count + draws, [](GLsizei n) { return n < 0; }))
    return refuse(c, GL_INVALID_VALUE), false;
  return validate(c, mode, Elements{});
}

}  // namespace

void multiDrawArrays(Context& c, GLenum mode, const GLint* first, const GLsizei* count, GLsizei draws) {
  if (!validate(c, mode, count, draws)) return;
  for (GLsizei i = 0; i < draws; ++i) drawArrays(c, mode, first[i], count[i]);
}

void multiDrawElements(Context& c, GLenum mode, const GLsizei* count, GLenum type, const void* const* indices,
                       GLsizei draws) {
  if (!isIndexType(type)) return refuse(c, GL_INVALID_ENUM);
  if (!validate(c, mode, count, draws)) return;
  for (GLsizei i = 0; i < draws; ++i) drawElements(c, mode, count[i], type, indices[i]);
}

void multiDrawElementsBaseVertex(Context& c, GLenum mode, const GLsizei* count, GLenum type,
                                 const void* const* indices, GLsizei draws, const GLint* base) {
  if (!isIndexType(type)) return refuse(c, GL_INVALID_ENUM);
  if (!validate(c, mode, count, draws)) return;
  for (GLsizei i = 0; i < draws; ++i) drawElementsBaseVertex(c, mode, count[i], type, indices[i], base[i]);
}

}  // namespace gluray::gl
