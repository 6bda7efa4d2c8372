// Runs of glBegin/glEnd pairs in Immediate: starts, ends, draws and records them.
#include "base/clock.h"
#include "gl/capture/mesh_builder.h"
#include "gl/capture/replay.h"
#include "gl/context/context.h"
#include "gl/context/geometry_run.h"
#include "gl/context/loose_run.h"
#include "gl/context/stub.h"

#include <GL/gl.h>

#include <cstring>
#include <utility>

namespace gluray::gl {

void Immediate::startRun() {
  stream_.start(bit(kPosition), p_.shadow.current.all(),
                p_.lists.compiling() ? weld_.inList() : weld_.inFrame(), welding_);
  inherited_.clear();
  ofArrays_ = false;
  if (p_.lists.compiling()) listValues_.start();
  path_ = DrawPath::immediate;
  reason_ = Reason::traced;
  open_ = !p_.lists.compiling();
  p_.attention.update();
}

void Immediate::closeRun() {
  if (p_.lists.compiling()) {
    recordRun();
    return startRun();
  }
  stream_.captured();  // may throw: the run is still open then, and the real OpenGL takes it over
  open_ = false;
  p_.shadow.current.sendLater(p_.shadow.real);
  drawRun();
  keepRunValues();
  p_.attention.update();
}

void Immediate::idle() {
  resumeExecuted();
  stream_.start(bit(kPosition), p_.shadow.current.all());
  p_.attention.update();
}

void Immediate::recordRun() {
  listValues_.finish(stream_);
  CapturedVertices run = stream_.takeRun();
  if (run.empty() && run.layout.mask == bit(kPosition)) return;
  SlotValues finals = p_.shadow.current.all();
  for (int s = kNormal; s < kSlotCount; ++s)
    if (run.layout.has(static_cast<Slot>(s)))
      std::memcpy(finals[static_cast<size_t>(s)].data(), stream_.get(run.layout, static_cast<Slot>(s)),
                  sizeOf(static_cast<Slot>(s)) * 4);
  GeometryRun* recorded = nullptr;
  try {
    ListEffect effect = listValues_.effect(run);
    recorded = &p_.lists.add(std::move(run), finals, std::move(inherited_), class_);
    recorded->setEffect(std::move(effect));
  } catch (...) {
    stream_.captured() = std::move(run);  // not yet moved from: Failsafe::fail() gives it to the real OpenGL
    throw;
  }
  inherited_.clear();
  p_.lists.executeAdded(*recorded);
}

void Immediate::loosen() {
  const Primitive open = stream_.openPrimitive();
  CapturedVertices run = stream_.takeRun();
  SlotValues finals = p_.shadow.current.all();
  for (int s = kNormal; s < kSlotCount; ++s)
    if (run.layout.has(static_cast<Slot>(s)))
      std::memcpy(finals[static_cast<size_t>(s)].data(), stream_.get(run.layout, static_cast<Slot>(s)),
                  sizeOf(static_cast<Slot>(s)) * 4);
  std::unique_ptr<ListOp> op;
  try {
    op = std::make_unique<LooseRun>(std::move(run), open, finals, std::move(inherited_));
  } catch (...) {
    stream_.captured() = std::move(run);  // not yet moved from
    throw;
  }
  p_.beginEnd.inside = Inside::nothing;
  startRun();
  p_.lists.append(op);
  recordMisuse();
}

void Immediate::leaveExecuted() {
  p_.beginEnd.executed = p_.beginEnd.inside == Inside::rasterised ? p_.beginEnd.inside : Inside::nothing;
  p_.beginEnd.inside = Inside::nothing;
}

void Immediate::keepRunValues() {
  const SlotMask slots = stream_.layout().mask & kVertexAttributes;
  CurrentValues& current = p_.shadow.current;
  if (insideBegin()) {  // of the real OpenGL, which takes over
    forEachSlot(slots, [&](Slot slot) {
      current.setInside(slot, stream_.get(slot)), sendAttribute(p_.shadow.real, slot, stream_.get(slot));
    });
  } else if (!ofArrays_) {
    SlotMask changed = 0;
    forEachSlot(slots, [&](Slot slot) {
      if (current.keepChanged(slot, stream_.get(slot))) changed |= bit(slot);
    });
    current.sendRun(p_.shadow.real, changed);
  }
  if (slots & bit(kColor)) p_.shadow.colorSet();
  if (const MaterialChange* last = stream_.lastMaterial()) {
    sendMaterial(p_.shadow.real, *last);
    if (!insideBegin()) p_.shadow.latch.letGo(p_.shadow.real), current.restore(p_.shadow.real);
    p_.shadow.touch(kMaterial);
  }
}

KnownMesh Immediate::meshOfRun() {
  const double start = nowSeconds();
  const CapturedVertices& run = stream_.captured();
  KnownMesh known;
  const Hash128 content = run.hash();
  if (!p_.shadow.group.meshes.find(content, known)) {
    known = buildMesh(run);
    p_.shadow.group.meshes.put(content, known);
    ++p_.counts.statistics.meshesBuilt;
    if (known.mesh) p_.counts.statistics.meshBytes += known.mesh->sizeBytes;
  }
  p_.counts.statistics.captureSeconds += nowSeconds() - start;
  return known;
}

/// The run, captured and ended.
class Immediate::RunDraw final : public DrawRequest {
 public:
  explicit RunDraw(Immediate& immediate) : i_(immediate), run_(immediate.stream_.captured()) {}
  Reason classifyState() override { return i_.p_.failsafe.aside() ? i_.p_.failsafe.reason() : i_.reason_; }
  KnownMesh mesh() override { return i_.meshOfRun(); }
  Reason classifyMesh(const KnownMesh& mesh) override {
    return i_.p_.classifier.classify(mesh, run_.materials);
  }
  Reason trace(const KnownMesh& mesh) override {
    i_.p_.filler.add(mesh.mesh, run_.layout.mask, run_.materials);
    i_.p_.counts.traced(i_.path_, countTriangles(run_));
    // Draws from arrays have stored the current values already; vertices of glBegin and glEnd have not yet.
    i_.p_.shadow.latch.drawn();
    return Reason::traced;
  }
  void meetPasses(PrimitiveClass primitive, Reason reason) override {
    i_.p_.raster.meetPasses(
        primitive, reason, [&] { return sampleTriangles(run_); }, [&] { return mesh(); });
  }
  Load load() override { return {i_.path_, i_.class_, countTriangles(run_)}; }
  Fate make() override {
    replay(i_.p_.shadow.real, run_);
    return Fate::rasterised;
  }

 private:
  Immediate& i_;
  const CapturedVertices& run_;
};

void Immediate::drawRun() {
  const CapturedVertices& run = stream_.captured();
  if (run.empty()) return;
  weld_.sawRun(run.indices.empty() ? run.vertexCount : run.indices.size());
  const DrawTimer timer(p_.counts.kinds());
  RunDraw request(*this);
  const CurrentValues::Held before = p_.shadow.current.held();
  if (p_.draws.submit(request) == Fate::traced || !ofArrays_) return;
  // The replay has set attributes that draws from arrays leave as they are.
  p_.shadow.current.holdAgain(before);
  p_.shadow.current.storeAside(p_.shadow.real, run.layout.mask & kVertexAttributes);
}

/// Sends what has been set since the last vertex into the open fragment.
void Immediate::sendRunValues() {
  for (int s = kNormal; s < kSlotCount; ++s) {
    const auto slot = static_cast<Slot>(s);
    if (stream_.has(slot) && slot != kMaterialNumber) sendAttribute(p_.shadow.real, slot, stream_.get(slot));
  }
  if (const MaterialChange* last = stream_.lastMaterial()) sendMaterial(p_.shadow.real, *last);
}

void Immediate::surrender() {
  CapturedVertices& run = stream_.captured();
  const bool open = p_.beginEnd.inside == Inside::captured;
  GLuint fragment = 0;
  if (!p_.lists.compiling()) {
    p_.shadow.current.sendLater(p_.shadow.real);
    p_.raster.noteUnsampledDraw(class_, Reason::evaluators);
    p_.raster.before(class_);
    if (open ? p_.beginEnd.inside != Inside::captured : !open_) return;  // a failure there has surrendered it
  }
  p_.shadow.sendBuffers();  // glArrayElement may follow
  if (p_.lists.compiling()) {
    fragment = p_.shadow.real.GenLists(1);
    p_.shadow.real.NewList(fragment, GL_COMPILE);
  }
  if (!p_.lists.compiling() && (!run.empty() || open)) {
    if (open && p_.counts.kinds()) p_.counts.kinds()->start();
    p_.counts.rasterised(p_.failsafe.aside() ? p_.failsafe.reason() : Reason::evaluators, path_, class_,
                         countTriangles(run));
  }
  replay(p_.shadow.real, run, inherited_);
  if (open) replayOpen(p_.shadow.real, run, stream_.openPrimitive(), inherited_);
  if (!p_.lists.compiling()) {
    if (open) openPrimitive_ = stream_.openPrimitive();
    keepRunValues();
    if (ofArrays_ && !open) p_.shadow.current.storeAside(p_.shadow.real, run.layout.mask & kVertexAttributes);
  } else {
    sendRunValues();
    if (!open) p_.shadow.real.EndList();
  }
  p_.beginEnd.inside = open ? Inside::rasterised : Inside::nothing;
  startRun();
  open_ = false;
  if (fragment && open)
    p_.beginEnd.fragment = fragment;
  else if (fragment)
    p_.lists.appendFragment(fragment);
}

}  // namespace gluray::gl
