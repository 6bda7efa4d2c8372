#include "gl/capture/immediate.h"

#include "gl/capture/replay.h"
#include "gl/capture/vertex_attribute_calls.h"
#include "gl/context.h"
#include "gl/handlers.h"
#include "gl/stub.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <cstring>

namespace gluray::gl {
namespace leaf {

void slowAttribute(Slot slot, const float* values) noexcept {
  if (Context* c = t_thread.context) c->insist([&] { c->immediate.attribute(slot, values); });
}

void slowVertex(float x, float y, float z, float w) noexcept {
  Context* c = t_thread.context;
  if (!c) return;
  c->insist([&] { c->immediate.vertex(x, y, z, w); });
}

void invalidUnit() noexcept {
  if (Context* c = t_thread.context) c->setError(GL_INVALID_ENUM);
}

void vertexAttribSlow(GLuint index, float x, float y, float z, float w) noexcept {
  Context* c = t_thread.context;
  if (!c) return;
  // A wrong index is refused by the real OpenGL in its turn among other errors, where those are its own.
  const bool below = index != 0 && c->immediate.inside() == Immediate::Inside::rasterised;
  if (c->passthrough() || c->info().core || below)
    c->real.VertexAttrib4f(index, x, y, z, w);
  else if (index == 0)
    vertex(x, y, z, w);
  else
    c->setError(GL_INVALID_VALUE);
}

}  // namespace leaf

void Immediate::attribute(Slot slot, const float* values) {
  if (c_.passthrough() || c_.info().core || (c_.direct() && !c_.compiling()))
    return sendAttribute(c_.real, slot, values);
  if (inside_ == Inside::rasterised) {
    sendAttribute(c_.real, slot, values);
    if (openFragment_) return;
    c_.current.keep(slot, values);
    return noteColor(slot);
  }
  if (open_ || c_.compiling()) {
    if (!stream_.has(slot)) addSlotToRun(slot);
    return stream_.set(slot, values);
  }
  if (c_.dirty & kCurrent) c_.refresh(kCurrent);
  // Colours count even where they are the same: the material may have changed in between.
  if (slot != kColor && std::memcmp(c_.current[slot], values, sizeOf(slot) * sizeof(float)) == 0) return;
  setCurrent(slot, values);
}

void Immediate::setCurrent(Slot slot, const float* values) {
  if (c_.current.anyDrawn()) c_.current.send(c_.real);
  c_.current.set(slot, values);
  noteColor(slot);
}

/// GL_COLOR_MATERIAL: the material follows the colour.
void Immediate::noteColor(Slot slot) {
  if (slot == kColor && c_.state.shading.colorMaterial != scene::ColorMaterial{}) c_.dirty |= kMaterial;
}

void Immediate::addSlotToRun(Slot slot) {
  constexpr uint32_t kCheapToWiden = 4096;  // vertices
  const bool widen = inside_ == Inside::captured || stream_.captured().vertexCount <= kCheapToWiden;
  if (!c_.compiling()) {
    if (widen)
      return stream_.addSlot(
          slot, slot == kMaterialNumber ? initialSlotValues()[kMaterialNumber].data() : current(slot));
    // Rather than rewriting many vertices, end their run here; the next starts with the slot.
    closeRun();
    startRun();
    return stream_.addSlot(slot, current(slot));
  }
  // What the caller of the list will have set is unknown now: vertices captured so far inherit it when the
  // list is called.
  if (inside_ != Inside::captured && !stream_.empty()) closeRun();
  if (!stream_.empty() && slot != kMaterialNumber)
    inherited_.push_back({slot, stream_.captured().vertexCount});
  stream_.addSlot(slot, initialSlotValues()[slot].data());
}

void Immediate::vertex(float x, float y, float z, float w) {
  if (inside_ == Inside::rasterised) ++openPrimitive_.count;
  if (c_.passthrough() || inside_ == Inside::rasterised) return c_.real.Vertex4f(x, y, z, w);
  if (inside_ == Inside::captured) return stream_.vertexSlow(x, y, z, w);
  // A vertex outside glBegin draws nothing, but in a list it may be called between the caller's glBegin and
  // glEnd.
  if (!c_.compiling()) return;
  closeRun();
  c_.lists.record([=](Context&) { leaf::vertex(x, y, z, w); }, true);
}

void Immediate::begin(GLenum mode) {
  if (insideBegin()) return c_.lists.misuse();
  if (mode > GL_POLYGON && !(mode >= GL_LINES_ADJACENCY && mode <= GL_TRIANGLE_STRIP_ADJACENCY)) {
    if (!c_.compiling()) return c_.setError(GL_INVALID_ENUM);
    return c_.lists.record([](Context& x) { x.setError(GL_INVALID_ENUM); });
  }
  const PrimitiveClass kind = mode > GL_POLYGON ? PrimitiveClass::lines : classOf(mode);
  if (c_.compiling()) {
    if (kind != class_ && !stream_.empty()) closeRun();
    class_ = kind;
  } else if (c_.direct()) {
    if (c_.kinds()) c_.kinds()->start();
    c_.drawsDirectly(DrawPath::immediate, kind, 0);  // end() knows its triangles
    openPrimitive_ = {mode, 0, 0};
    t_thread.directVertices = 0;
    inside_ = Inside::rasterised;
    c_.real.Begin(mode);
    return c_.updateAttention();
  } else if (!open_ || kind != class_) {
    closeRunIfOpen();
    c_.works();
    c_.refresh(kDrawGroups);
    class_ = kind;
    const Reason reason = c_.triage(kind);
    if (reason != Reason::traced) {
      if (!canDraw())
        return c_.setError(GL_INVALID_FRAMEBUFFER_OPERATION);  // glBegin fails: no primitive is open
    }
    const bool captured = reason == Reason::traced || c_.mayMeetPasses(kind) || c_.isPass(kind, reason);
    if (!captured) {
      c_.beforeRasterDraw(kind);
      c_.sendBuffers();  // glArrayElement may follow
      if (c_.kinds()) c_.kinds()->start();
      c_.countRaster(reason, DrawPath::immediate, kind, 0);  // end() knows its triangles
      openPrimitive_ = {mode, 0, 0};
      inside_ = Inside::rasterised;
      c_.real.Begin(mode);
      return c_.updateAttention();
    }
    startRun();
    reason_ = reason;
  }
  stream_.begin(mode);
  inside_ = Inside::captured;
  c_.updateAttention();
}

void Immediate::countOpenPrimitive() {
  if (c_.direct()) openPrimitive_.count += t_thread.directVertices;
  const uint64_t triangles = countTriangles(openPrimitive_.mode, openPrimitive_.count);
  c_.statistics.trianglesRasterised += triangles;
  c_.noteLoad(triangles);
  if (!c_.kinds()) return;
  c_.kinds()->addTriangles(triangles);
  c_.kinds()->stop();
}

bool Immediate::canDraw() const {
  return c_.state.target.framebuffer == 0 ||
         c_.real.CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

void Immediate::end() {
  if (!insideBegin() && c_.compiling()) {  // of the caller's glBegin
    closeRun();
    c_.lists.record([](Context& x) { x.immediate.end(); }, true);
    return recordMisuse();
  }
  if (!insideBegin()) return c_.setError(GL_INVALID_OPERATION);
  if (inside_ == Inside::rasterised) {
    c_.real.End();
    if (!openFragment_) countOpenPrimitive();
    if (const GLuint id = std::exchange(openFragment_, 0)) {
      c_.real.EndList();
      c_.lists.appendFragment(id);
    }
  } else {
    stream_.end();
  }
  inside_ = Inside::nothing;
  c_.updateAttention();
  recordMisuse();
}

/// The error of a wrong command inside the primitive of a list, behind the primitive.
void Immediate::recordMisuse() {
  const GLenum error = c_.lists.takeMisuse();
  if (error == GL_NO_ERROR) return;
  closeRun();
  c_.lists.record([error](Context& x) { x.setError(error); }, true);
}

void Immediate::material(GLenum face, GLenum pname, const float* params) {
  MaterialChange change;
  const bool known = change.set(face, pname, params);
  const bool refused = pname == GL_SHININESS && (params[0] < 0 || params[0] > 128);
  // An error of the moment when the list is called, in the real OpenGL's opinion of it.
  if (c_.compiling() && !insideBegin() && !c_.passthrough() && (!known || refused))
    return c_.lists.recordFragment([&] { c_.real.Materialfv(face, pname, params); });
  if (c_.compiling() && inside_ == Inside::captured && !known) return c_.lists.misuse(GL_INVALID_ENUM);
  if (c_.passthrough() || inside_ == Inside::rasterised || !known) {
    if (!openFragment_) c_.dirty |= kMaterial;
    return c_.real.Materialfv(face, pname, params);
  }
  if (refused) return c_.lists.misuse(GL_INVALID_VALUE);
  if (!open_ && !c_.compiling()) {
    c_.syncCurrent();
    c_.dirty |= kMaterial;
    if (!c_.lists.calling()) c_.latch.sent(face, pname, params);
    return c_.real.Materialfv(face, pname, params);
  }
  if (const MaterialChange* last = stream_.lastMaterial()) change = *last;
  change.set(face, pname, params);
  change.outside = c_.compiling() && !insideBegin();
  if (!stream_.has(kMaterialNumber)) addSlotToRun(kMaterialNumber);
  // addSlotToRun may have ended the run of a list: the change then starts afresh, on top of what the ended
  // run leaves.
  const float number = stream_.addMaterial(change);
  stream_.set(kMaterialNumber, &number);
}

void Immediate::rasterElement(GLint i) {
  ++openPrimitive_.count;
  c_.real.ArrayElement(i);
}

const float* Immediate::current(Slot slot) {
  if (c_.dirty & kCurrent && !c_.direct()) c_.refresh(kCurrent);
  if ((open_ || c_.compiling()) && stream_.has(slot)) return stream_.get(slot);
  if (c_.direct()) {
    c_.current.read(c_.real, slot);
    c_.latch.restore(c_.real);
  }
  return c_.current[slot];
}

}  // namespace gluray::gl
