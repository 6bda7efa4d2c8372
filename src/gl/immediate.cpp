// glBegin to glEnd, current attributes and materials: the Context's side of the leaf path.
#include "base/clock.h"
#include "gl/context.h"
#include "gl/handlers.h"
#include "gl/leaf.h"
#include "gl/list.h"
#include "gl/mesh_builder.h"
#include "gl/replay.h"
#include "gl/stub.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <cstring>

namespace gluray::gl {
namespace {

// Vertices. What comes in every frame is captured and compared sooner than welded, but memory is for runs of
// a gigabyte or so.
constexpr uint32_t kWorthWelding = 1u << 16, kTooLarge = 56'000'000;

}  // namespace

namespace leaf {

void slowAttribute(Slot slot, const float* values) noexcept {
  if (Context* c = t_thread.context) c->insist([&] { c->attribute(slot, values); });
}

void slowVertex(float x, float y, float z, float w) noexcept {
  Context* c = t_thread.context;
  if (!c) return;
  c->insist([&] { c->vertex(x, y, z, w); });
}

void invalidUnit() noexcept {
  if (Context* c = t_thread.context) c->setError(GL_INVALID_ENUM);
}

void vertexAttribSlow(GLuint index, float x, float y, float z, float w) noexcept {
  Context* c = t_thread.context;
  if (!c) return;
  // A wrong index is refused by the real OpenGL in its turn among other errors, where those are its own.
  const bool below = index != 0 && c->inside() == Context::Inside::rasterised;
  if (c->passthrough() || c->info().core || below)
    c->real.VertexAttrib4f(index, x, y, z, w);
  else if (index == 0)
    vertex(x, y, z, w);
  else
    c->setError(GL_INVALID_VALUE);
}

}  // namespace leaf

void Context::attribute(Slot slot, const float* values) {
  if (passthrough_ || info_.core || (direct_ && !compiling())) return sendAttribute(real, slot, values);
  if (inside_ == Inside::rasterised) {
    sendAttribute(real, slot, values);
    return openFragment_ ? void() : current_.keep(slot, values);
  }
  if (runOpen_ || compiling()) {
    if (!stream_.has(slot)) addSlotToRun(slot);
    return stream_.set(slot, values);
  }
  if (dirty & kCurrent) refresh(kCurrent);
  current_.set(slot, values);
  if (slot == kColor && state.shading.colorMaterial != scene::ColorMaterial{}) dirty |= kMaterial;
}

void Context::addSlotToRun(Slot slot) {
  constexpr uint32_t kCheapToWiden = 4096;  // vertices
  const bool widen = inside_ == Inside::captured || stream_.captured().vertexCount <= kCheapToWiden;
  if (!compiling()) {
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

void Context::vertex(float x, float y, float z, float w) {
  if (inside_ == Inside::rasterised) ++openPrimitive_.count;
  if (passthrough_ || inside_ == Inside::rasterised) return real.Vertex4f(x, y, z, w);
  if (inside_ == Inside::captured) return stream_.vertexSlow(x, y, z, w);
  // A vertex outside glBegin draws nothing, but in a list it may be called between the caller's glBegin and
  // glEnd.
  if (!compiling()) return;
  closeRun();
  record([=](Context&) { leaf::vertex(x, y, z, w); }, true);
}

void Context::begin(GLenum mode) {
  if (insideBegin()) return misuse();
  if (mode > GL_POLYGON && !(mode >= GL_LINES_ADJACENCY && mode <= GL_TRIANGLE_STRIP_ADJACENCY)) {
    if (!compiling()) return setError(GL_INVALID_ENUM);
    return record([](Context& x) { x.setError(GL_INVALID_ENUM); });
  }
  const PrimitiveClass kind = mode > GL_POLYGON ? PrimitiveClass::lines : classOf(mode);
  if (compiling()) {
    if (kind != runClass_ && !stream_.empty()) closeRun();
    runClass_ = kind;
  } else if (direct_) {
    if (kinds()) kinds()->start();
    drawsDirectly(DrawPath::immediate, kind, 0);  // end() knows its triangles
    openPrimitive_ = {mode, 0, 0};
    t_thread.directVertices = 0;
    inside_ = Inside::rasterised;
    real.Begin(mode);
    return updateAttention();
  } else if (!runOpen_ || kind != runClass_) {
    if (runOpen_) closeRun();
    works();
    refresh(kDrawGroups);
    runClass_ = kind;
    const Reason reason = triage(kind);
    if (reason != Reason::traced) {
      if (!canDraw())
        return setError(GL_INVALID_FRAMEBUFFER_OPERATION);  // glBegin fails: no primitive is open
    }
    const bool captured = reason == Reason::traced || mayMeetPasses(kind) || isPass(kind, reason);
    if (!captured) {
      beforeRasterDraw(kind);
      sendBuffers();  // glArrayElement may follow
      if (kinds()) kinds()->start();
      countRaster(reason, DrawPath::immediate, kind, 0);  // end() knows its triangles
      openPrimitive_ = {mode, 0, 0};
      inside_ = Inside::rasterised;
      real.Begin(mode);
      return updateAttention();
    }
    startRun();
    runReason_ = reason;
  }
  stream_.begin(mode);
  inside_ = Inside::captured;
  updateAttention();
}

void Context::countOpenPrimitive() {
  if (direct_) openPrimitive_.count += t_thread.directVertices;
  const uint64_t triangles = countTriangles(openPrimitive_.mode, openPrimitive_.count);
  statistics.trianglesRasterised += triangles;
  noteLoad(triangles);
  if (!kinds()) return;
  kinds()->addTriangles(triangles);
  kinds()->stop();
}

bool Context::canDraw() const {
  return state.target.framebuffer == 0 ||
         real.CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

void Context::end() {
  if (!insideBegin() && compiling()) {  // of the caller's glBegin
    closeRun();
    return record([](Context& x) { x.end(); }, true);
  }
  if (!insideBegin()) return setError(GL_INVALID_OPERATION);
  if (inside_ == Inside::rasterised) {
    real.End();
    if (!openFragment_) countOpenPrimitive();
    if (const GLuint id = std::exchange(openFragment_, 0)) {
      real.EndList();
      appendFragment(id);
    }
  } else {
    stream_.end();
  }
  inside_ = Inside::nothing;
  updateAttention();
  if (misused_ == GL_NO_ERROR) return;
  const GLenum error = std::exchange(misused_, GL_NO_ERROR);
  closeRun();
  record([error](Context& x) { x.setError(error); }, true);
}

void Context::startRun() {
  stream_.start(bit(kPosition), current_.all(), compiling() ? kWorthWelding : kTooLarge, welding_);
  inherited_.clear();
  runPath_ = DrawPath::immediate;
  runReason_ = Reason::traced;
  runOpen_ = !compiling();
  updateAttention();
}

void Context::closeRun() {
  if (compiling()) {
    recordRun();
    return startRun();
  }
  runOpen_ = false;
  drawRun();
  keepRunValues();
  updateAttention();
}

void Context::keepRunValues() {
  for (int s = kNormal; s < kSlotCount; ++s) {
    const auto slot = static_cast<Slot>(s);
    if (!stream_.has(slot) || slot == kMaterialNumber) continue;
    current_.set(slot, stream_.get(slot));
    if (slot == kColor && state.shading.colorMaterial != scene::ColorMaterial{}) dirty |= kMaterial;
  }
  if (const MaterialChange* last = stream_.lastMaterial()) {
    current_.send(real);
    sendMaterial(real, *last);
    if (!insideBegin()) latch_.letGo(real);
    dirty |= kMaterial;
  }
}

KnownMesh Context::meshOfRun() {
  const double start = nowSeconds();
  const Captured& run = stream_.captured();
  KnownMesh known;
  const Hash128 content = run.hash();
  if (!group_->meshes.find(content, known)) {
    known = buildMesh(run);
    group_->meshes.put(content, known);
    ++statistics.meshesBuilt;
    if (known.mesh) statistics.meshBytes += known.mesh->sizeBytes;
  }
  statistics.captureSeconds += nowSeconds() - start;
  return known;
}

void Context::drawRun() {
  const Captured& run = stream_.captured();
  if (run.empty()) return;
  const DrawTimer timer(kinds());
  const Reason reason = attempt([&] {
    if (aside_) return Reason::failure;
    if (runReason_ != Reason::traced) return runReason_;
    const KnownMesh known = meshOfRun();
    const Reason fine = triage(known, run.materials);
    if (fine == Reason::traced) addInstance(known.mesh, run.layout.mask, run.materials);
    return fine;
  });
  const uint64_t triangles = countTriangles(run);
  if (reason == Reason::traced) return countTraced(runPath_, triangles);
  if (mayMeetPasses(runClass_)) protect([&] { meetPasses(sampleTriangles(run)); });
  if (isPass(runClass_, reason)) protect([&] { rememberPass(meshOfRun()); });
  countRaster(reason, runPath_, runClass_, triangles);
  beforeRasterDraw(runClass_);
  sendBuffers();
  replay(real, run);
}

/// What has been set since the last vertex, into the fragment that is open.
void Context::sendRunValues() {
  for (int s = kNormal; s < kSlotCount; ++s) {
    const auto slot = static_cast<Slot>(s);
    if (stream_.has(slot) && slot != kMaterialNumber) sendAttribute(real, slot, stream_.get(slot));
  }
  if (const MaterialChange* last = stream_.lastMaterial()) sendMaterial(real, *last);
}

void Context::surrenderRun() {
  Captured& run = stream_.captured();
  const bool open = inside_ == Inside::captured;
  GLuint fragment = 0;
  if (!compiling()) showLagged();
  sendBuffers();        // glArrayElement may follow
  current_.send(real);  // not into the list
  if (compiling()) {
    fragment = real.GenLists(1);
    real.NewList(fragment, GL_COMPILE);
  }
  if (!compiling() && (!run.empty() || open)) {
    if (open && kinds()) kinds()->start();
    countRaster(aside_ ? Reason::failure : Reason::evaluators, runPath_, runClass_, countTriangles(run));
  }
  replay(real, run);
  if (open) replayOpen(real, run, stream_.openPrimitive());
  if (!compiling()) {
    if (open) openPrimitive_ = stream_.openPrimitive();
    keepRunValues();
    current_.send(real);  // legal inside glBegin too: what was set since the last vertex
  } else {
    sendRunValues();
    if (!open) real.EndList();
  }
  inside_ = open ? Inside::rasterised : Inside::nothing;
  startRun();
  runOpen_ = false;
  if (fragment && open)
    openFragment_ = fragment;
  else if (fragment)
    appendFragment(fragment);
}

void Context::appendFragment(GLuint realList) {
  stencilSet(*this);  // nobody knows what is in it
  std::unique_ptr<ListOp> op;
  insist([&] { op = std::make_unique<FragmentOp>(realList, group_); });
  insist([&] { append(op); });
}

void Context::material(GLenum face, GLenum pname, const float* params) {
  MaterialChange change;
  const bool known = change.set(face, pname, params);
  const bool refused = pname == GL_SHININESS && (params[0] < 0 || params[0] > 128);
  // An error of the moment when the list is called, in the real OpenGL's opinion of it.
  if (compiling() && !insideBegin() && !passthrough_ && (!known || refused))
    return recordFragment([&] { real.Materialfv(face, pname, params); });
  if (compiling() && inside_ == Inside::captured && !known) return misuse(GL_INVALID_ENUM);
  if (passthrough_ || inside_ == Inside::rasterised || !known) return real.Materialfv(face, pname, params);
  if (refused) return misuse(GL_INVALID_VALUE);
  if (!runOpen_ && !compiling()) {
    syncCurrent();
    dirty |= kMaterial;
    if (listDepth_ == 0) latch_.sent(face, pname, params);
    return real.Materialfv(face, pname, params);
  }
  if (const MaterialChange* last = stream_.lastMaterial()) change = *last;
  change.set(face, pname, params);
  if (!stream_.has(kMaterialNumber)) addSlotToRun(kMaterialNumber);
  // addSlotToRun may have ended the run of a list: the change then starts afresh, on top of what the ended
  // run leaves.
  const float number = stream_.addMaterial(change);
  stream_.set(kMaterialNumber, &number);
}

const float* Context::current(Slot slot) {
  if (dirty & kCurrent && !direct_) refresh(kCurrent);
  if ((runOpen_ || compiling()) && stream_.has(slot)) return stream_.get(slot);
  if (direct_) {
    current_.read(real, slot);
    latch_.restore(real);
  }
  return current_[slot];
}

}  // namespace gluray::gl
