#include "gl/context/immediate.h"

#include "gl/capture/replay.h"
#include "gl/capture/vertex_attribute_calls.h"
#include "gl/context/context.h"
#include "gl/context/handlers.h"
#include "gl/context/stub.h"
#include "gl/real/extensions.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <glm/gtc/type_ptr.hpp>

#include <cstring>
#include <utility>

namespace gluray::gl {
namespace vertexcall {

void slowAttribute(Slot slot, const float* values) noexcept {
  if (Context* c = t_thread.context) c->failsafe.insist([&] { c->immediate.attribute(slot, values); });
}

void slowVertex(float x, float y, float z, float w) noexcept {
  Context* c = t_thread.context;
  if (!c) return;
  c->failsafe.insist([&] { c->immediate.vertex(x, y, z, w); });
}

void invalidUnit() noexcept {
  if (Context* c = t_thread.context) c->errors.set(GL_INVALID_ENUM);
}

void vertexAttribSlow(GLuint index, float x, float y, float z, float w) noexcept {
  Context* c = t_thread.context;
  if (!c) return;
  // Where the real OpenGL raises a primitive's errors, it refuses wrong indices too, so errors stay in order.
  const bool below = index != 0 && c->immediate.inside() == Immediate::Inside::rasterised;
  // Outside of glBegin and glEnd attribute 0 is no vertex, but a value for programs that draw without its
  // array.
  const bool value = index == 0 && !c->immediate.insideBegin();
  const auto set = [&] { c->real.VertexAttrib4f(index, x, y, z, w); };
  if (c->info().off || c->info().core || below)
    set();
  else if (value && c->lists.compiling())
    c->failsafe.insist([&] { c->lists.recordFragment(set); });
  else if (value)
    set();
  else if (index == 0)
    vertex(x, y, z, w);
  else
    c->errors.set(GL_INVALID_VALUE);
}

}  // namespace vertexcall

void Immediate::attribute(Slot slot, const float* values) {
  if (p_.shadow.info.off || p_.shadow.info.core || (p_.clock.passesThrough() && !p_.lists.compiling()))
    return sendAttribute(p_.shadow.real, slot, values);
  if (p_.beginEnd.inside == Inside::rasterised) {
    sendAttribute(p_.shadow.real, slot, values);
    if (p_.beginEnd.fragment) return;
    p_.shadow.current.setInside(slot, values);
    if (slot == kColor) p_.shadow.colorSet();
    return;
  }
  if (takesSlot(slot)) {
    // Set after draws from arrays, in a list: Mesa holds it back while the next primitive is drawn.
    const bool outside = p_.beginEnd.inside != Inside::captured;
    if (p_.lists.compiling() && ofArrays_ && outside) closeRun();
    if (!stream_.has(slot)) addSlotToRun(slot);
    if (p_.lists.compiling() && outside) listValues_.set(stream_, slot, values);
    if (open_ && ofArrays_ && outside) p_.shadow.current.setLater(slot, values);
    return stream_.set(slot, values);
  }
  p_.shadow.current.set(p_.shadow.real, slot, values);
  if (slot == kColor) p_.shadow.colorSet();
}

/// Whether values of the slot go into a run. Rather than rewriting many vertices for a slot that they lack,
/// ends their run.
bool Immediate::takesSlot(Slot slot) {
  constexpr uint32_t kCheapToWiden = 4096;  // vertices
  if (p_.lists.compiling()) return true;
  if (open_ && p_.beginEnd.inside != Inside::captured && !stream_.has(slot) &&
      stream_.captured().vertexCount > kCheapToWiden)
    closeRun();
  return open_;
}

void Immediate::addSlotToRun(Slot slot) {
  if (!p_.lists.compiling()) {
    if (slot == kMaterialNumber) return stream_.addSlot(slot, initialSlotValues()[slot].data());
    const float* const now = current(slot);
    // The real OpenGL does not yet have the values of a run of array draws.
    if (slot != kColor || stream_.empty() || ofArrays_) return stream_.addSlot(slot, now);
    const glm::vec4 followed = p_.shadow.colorOfMaterial();
    return stream_.addSlot(slot, glm::value_ptr(followed));
  }
  // The value that the list's caller will have set is unknown: vertices captured so far inherit it when the
  // list is called.
  if (p_.beginEnd.inside != Inside::captured && !stream_.empty()) closeRun();
  if (p_.beginEnd.inside == Inside::captured) listValues_.addSlot(stream_);
  if (!stream_.empty() && slot != kMaterialNumber)
    inherited_.push_back({slot, stream_.captured().vertexCount});
  stream_.addSlot(slot, initialSlotValues()[slot].data());
}

void Immediate::vertex(float x, float y, float z, float w) {
  if (p_.beginEnd.inside == Inside::rasterised) ++openPrimitive_.count;
  if (p_.shadow.info.off || p_.beginEnd.inside == Inside::rasterised)
    return p_.shadow.real.Vertex4f(x, y, z, w);
  if (p_.beginEnd.inside == Inside::captured) return stream_.vertexSlow(x, y, z, w);
  // A vertex outside glBegin draws nothing, unless its list is called inside the caller's glBegin.
  if (!p_.lists.compiling()) return;
  closeRun();
  p_.lists.record([=](Context&) { vertexcall::vertex(x, y, z, w); }, true);
}

void Immediate::begin(GLenum mode, bool arrays) {
  if (insideBegin()) return p_.lists.misuse();
  if (!isPrimitive(p_.shadow.real, mode)) {
    if (!p_.lists.compiling()) return p_.shadow.errors.set(GL_INVALID_ENUM);
    return p_.lists.record([](Context& x) { x.errors.set(GL_INVALID_ENUM); });
  }
  const PrimitiveClass kind = mode > GL_POLYGON ? PrimitiveClass::lines : classOf(mode);
  if (p_.lists.compiling()) {
    const bool continues = kind != class_ && !stream_.empty() && listValues_.isDrawing();
    if (kind != class_ && !stream_.empty()) closeRun();
    class_ = kind;
    listValues_.begin(stream_, continues);
    ofArrays_ = false;
  } else if (p_.clock.passesThrough()) {
    forgetAnswer();
    if (p_.counts.kinds()) p_.counts.kinds()->start();
    p_.passthrough.takes(DrawPath::immediate, kind, 0);  // end() counts its triangles
    openPrimitive_ = {mode, 0, 0};
    t_thread.passthroughVertices = 0;
    p_.beginEnd.inside = Inside::rasterised;
    p_.shadow.real.Begin(mode);
    return p_.attention.passed(true);
  } else if (!open_ || kind != class_ || ofArrays_ != arrays) {
    closeRunIfOpen();
    p_.passthrough.works();
    p_.shadow.refresh(kDrawGroups);
    class_ = kind;
    const Reason reason = p_.classifier.classify(kind);
    if (reason != Reason::traced && !canBegin(mode)) return;  // no primitive is open
    const bool captured = reason == Reason::traced || p_.raster.needsVertices(kind, reason);
    if (!captured) {
      p_.draws.beginRasterised(DrawPath::immediate, kind, reason);  // end() counts its triangles
      openPrimitive_ = {mode, 0, 0};
      p_.beginEnd.inside = Inside::rasterised;
      p_.shadow.current.begun(nullptr);
      p_.shadow.real.Begin(mode);
      return p_.attention.update();
    }
    startRun();
    ofArrays_ = arrays;
    reason_ = reason;
  }
  stream_.begin(mode);
  p_.beginEnd.inside = Inside::captured;
  p_.attention.update();
}

void Immediate::countOpenPrimitive() {
  if (p_.clock.passesThrough()) openPrimitive_.count += t_thread.passthroughVertices;
  const uint64_t triangles = countTriangles(openPrimitive_.mode, openPrimitive_.count);
  p_.counts.statistics.trianglesRasterised += triangles;
  p_.counts.load(triangles);
  if (!p_.counts.kinds()) return;
  p_.counts.kinds()->addTriangles(triangles);
  p_.counts.kinds()->stop();
}

/// Whether the real OpenGL's glBegin succeeds; raises its error if not. Framebuffers may be incomplete, and
/// programs may not fit them, the blending or the primitive. A draw of no vertices is refused for the same
/// reasons. An empty glBegin and glEnd would change what follows: Mesa 22.3 then loses line strips. Buffers
/// that are mapped refuse draws from arrays, but not glBegin: then it is asked.
bool Immediate::askCanBegin(GLenum mode) {
  const RealGl& real = p_.shadow.real;
  p_.shadow.errors.keepPending();
  real.DrawArrays(mode, 0, 0);
  p_.shadow.current.restore(real);
  if (p_.shadow.errors.takeReal() == GL_NO_ERROR) return true;
  real.Begin(mode), real.End();
  const GLenum error = p_.shadow.errors.takeReal();
  if (error != GL_NO_ERROR) p_.shadow.errors.set(error);
  return error == GL_NO_ERROR;
}

/// The answer is kept until a command comes that may change it: a draw of no vertices makes Mesa draw all
/// primitives before it, one by one.
bool Immediate::canBegin(GLenum mode) {
  if (p_.shadow.target().framebuffer == 0 && p_.shadow.raster().program == 0) return true;
  if (mode == canBegin_) return true;
  const bool can = askCanBegin(mode);
  canBegin_ = can && !p_.lists.compiling() && !p_.lists.calling() ? mode : kNoMode;
  return can;
}

void Immediate::end() {
  if (!insideBegin() && p_.lists.compiling()) {  // ends the caller's glBegin
    closeRun();
    p_.lists.record([](Context& x) { x.immediate.end(); }, true);
    return recordMisuse();
  }
  if (!insideBegin()) return p_.shadow.errors.set(GL_INVALID_OPERATION);
  if (p_.beginEnd.inside == Inside::rasterised) {
    p_.shadow.real.End();
    if (!p_.beginEnd.fragment) countOpenPrimitive(), p_.shadow.current.ended(openPrimitive_.count > 0);
    if (std::exchange(hasElements_, false) && !p_.beginEnd.fragment && !p_.clock.passesThrough())
      p_.shadow.current.readInside(p_.shadow.real, slotsOf(p_.shadow.arrays()) & kVertexAttributes);
    if (const GLuint id = std::exchange(p_.beginEnd.fragment, 0)) {
      p_.shadow.real.EndList();
      p_.lists.appendFragment(id);
    }
  } else {
    stream_.end();
    for (InheritedSlot& slot : inherited_)  // vertices of incomplete primitives are dropped
      slot.vertices = std::min(slot.vertices, stream_.captured().vertexCount);
  }
  const bool passed =
      p_.beginEnd.inside == Inside::rasterised && p_.clock.passesThrough() && !p_.lists.compiling();
  p_.beginEnd.inside = Inside::nothing;
  passed ? p_.attention.passed(open_) : p_.attention.update();
  if (p_.lists.misused()) recordMisuse();
}

/// Records the error of an illegal command inside a list's primitive, after that primitive.
void Immediate::recordMisuse() {
  const GLenum error = p_.lists.takeMisuse();
  if (error == GL_NO_ERROR) return;
  closeRun();
  p_.lists.record([error](Context& x) { x.errors.set(error); }, true);
}

void Immediate::material(GLenum face, GLenum pname, const float* params) {
  const bool refused = pname == GL_SHININESS && (params[0] < 0 || params[0] > 128);
  if (p_.clock.passesThrough() && !p_.lists.compiling() && !open_) {
    p_.shadow.touch(kMaterial);
    if (!insideBegin() && !p_.lists.calling() && !refused) p_.shadow.latch.sent(face, pname, params);
    return p_.shadow.real.Materialfv(face, pname, params);  // raises the errors
  }
  MaterialChange change;
  const bool known = change.set(face, pname, params);
  // The real OpenGL decides about the error when the list is called.
  if (p_.lists.compiling() && !insideBegin() && !p_.shadow.info.off && (!known || refused))
    return p_.lists.recordFragment([&] { p_.shadow.real.Materialfv(face, pname, params); });
  if (p_.lists.compiling() && p_.beginEnd.inside == Inside::captured && !known)
    return p_.lists.misuse(GL_INVALID_ENUM);
  if (p_.shadow.info.off || p_.beginEnd.inside == Inside::rasterised || !known) {
    if (!p_.beginEnd.fragment) p_.shadow.touch(kMaterial);
    return p_.shadow.real.Materialfv(face, pname, params);
  }
  if (refused) return p_.lists.misuse(GL_INVALID_VALUE);
  // Programs have materials as uniforms, one for all vertices of a run.
  if (open_ && !insideBegin() && (ofArrays_ || p_.shadow.raster().program != 0)) closeRun();
  if (!takesSlot(kMaterialNumber)) {
    p_.shadow.materialSet(change);
    p_.shadow.latch.sent(face, pname, params);
    // The real OpenGL holds materials back as it does attributes.
    p_.shadow.current.setInside(kMaterialNumber, p_.shadow.current[kMaterialNumber]);
    return p_.shadow.real.Materialfv(face, pname, params);
  }
  if (const MaterialChange* last = stream_.lastMaterial()) change = *last;
  change.set(face, pname, params);
  change.outside = p_.lists.compiling() && !insideBegin();
  if (!stream_.has(kMaterialNumber)) addSlotToRun(kMaterialNumber);
  // addSlotToRun may have ended a list's run: this is then the new run's first change, applied to what the
  // ended run leaves.
  if (change.outside) listValues_.set(stream_, kMaterialNumber, nullptr);
  const float number = stream_.addMaterial(change);
  stream_.set(kMaterialNumber, &number);
}

void Immediate::rasterElement(GLint i) {
  ++openPrimitive_.count;
  hasElements_ = true;
  p_.shadow.real.ArrayElement(i);
}

const float* Immediate::current(Slot slot) {
  if (!p_.clock.passesThrough()) p_.shadow.refresh(kCurrent);
  if ((open_ || p_.lists.compiling()) && stream_.has(slot)) return stream_.get(slot);
  if (p_.clock.passesThrough()) {
    p_.shadow.current.read(p_.shadow.real, slot);
    p_.shadow.latch.restore(p_.shadow.real);
  }
  return p_.shadow.current[slot];
}

}  // namespace gluray::gl
