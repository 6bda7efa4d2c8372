// Handlers of array draws, and array draws by fixed function.
#include "gl/commands/array_draws.h"

#include "base/clock.h"
#include "base/timeline.h"
#include "gl/arrays/array_indices.h"
#include "gl/capture/vertex_attribute_calls.h"
#include "gl/commands/raster_light.h"
#include "gl/context/handlers.h"
#include "gl/context/geometry_run.h"
#include "gl/real/extensions.h"
#include "gl/context/stub.h"

#include <algorithm>
#include <cstring>
#include <span>

namespace gluray::gl {

void refuse(Context& c, GLenum error) {
  // Inside glBegin GL_INVALID_OPERATION comes first, except while a list is compiled.
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

constexpr GLsizei kSmall = 192;  // most vertices of a draw that joins a run instead of becoming a mesh

/// Records a draw in a list. Its arrays are read now, as display lists demand (GL 2.1, 5.4).
void recordDraw(Context& c, GLenum mode, const Elements& e) {
  c.shadow.refresh(kFixedArrays);
  // Without a position array the draw may use the current position: the real OpenGL decides.
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

}  // namespace

Reason traceFixedArrays(Context& c, GLenum mode, const Elements& e) {
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

void meetFixedArrays(Context& c, PrimitiveClass kind, Reason reason, GLenum mode, const Elements& e) {
  c.shadow.refresh(kModelview);
  if (!c.raster.needsVertices(kind, reason)) return c.raster.passUnseen(kind, reason);
  c.shadow.refresh(kFixedArrays);
  if (!c.shadow.arrays.vertex.enabled || c.shadow.arrays.reason != Reason::traced) return;
  c.raster.meetPasses(
      kind, reason, [&] { return sampleTriangles(c.real, c.shadow.arrays, mode, e); },
      [&] { return meshOf(c, c.shadow.arrays, mode, e); });
}

namespace {

/// Adds a small draw to the open run of vertices, if it can be traced. False: nothing was done.
bool joinsRun(Context& c, GLenum mode, const Elements& e) {
  const bool plain = e.instances < 0 && mode <= GL_POLYGON && c.shadow.arrays.reason == Reason::traced &&
                     c.shadow.arrays.vertex.enabled;
  if (!plain || e.count > kSmall || c.triage.of(classOf(mode)) != Reason::traced) return false;
  const Reason joined = c.failsafe.attempt([&] {
    c.immediate.drawSmall(mode, vertexNumbers(c.real, c.shadow.arrays, e), pathOf(e));
    return Reason::traced;
  });
  return joined == Reason::traced;
}

/// Traces or rasterises a draw of fixed function's arrays.
void drawFixedArrays(Context& c, GLenum mode, const Elements& e) {
  c.immediate.closeRunIfOpen();
  c.shadow.refresh(kDrawGroups);  // the run may have set a material
  // Without a position array the draw may use the current position: the real OpenGL decides.
  const bool known = c.shadow.arrays.vertex.enabled && e.instances < 0;
  const Reason reason = known ? traceFixedArrays(c, mode, e) : Reason::arrayState;
  if (reason == Reason::traced) return;
  const PrimitiveClass kind = kindOf(mode);
  meetFixedArrays(c, kind, reason, mode, e);
  c.counts.rasterised(reason, pathOf(e), kind, countTriangles(mode, static_cast<uint64_t>(e.count)));
  c.raster.before(kind);
  c.shadow.sendBuffers();
  if (!known || !c.culled.draw(mode, e)) drawReal(c.real, mode, e);
  if (known) lightRasterised(c, mode, e);
}

void draw(Context& c, GLenum mode, const Elements& e) {
  if (!validate(c, mode, e) || e.first < 0) return;  // elements before the array are undefined
  // An empty draw draws nothing, but the real OpenGL may raise errors for it.
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
  if (drawUntraced(c, mode, e)) return;
  c.shadow.refresh(kRaster);
  if (c.shadow.state.raster.program != 0 || c.info().core) return drawByProgram(c, mode, e);
  c.shadow.refresh(kDrawGroups | kFixedArrays);
  if (!joinsRun(c, mode, e)) drawFixedArrays(c, mode, e);
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
