// Runs of glBegin and glEnd pairs: when they start and end, and what becomes of them.
#include "base/clock.h"
#include "gl/capture/mesh_builder.h"
#include "gl/capture/replay.h"
#include "gl/context.h"
#include "gl/lists/geometry_run.h"
#include "gl/lists/loose_run.h"
#include "gl/stub.h"

#include <GL/gl.h>

#include <cstring>
#include <utility>

namespace gluray::gl {

void Immediate::startRun() {
  stream_.start(bit(kPosition), c_.current.all(), c_.compiling() ? weld_.inList() : weld_.inFrame(),
                welding_);
  inherited_.clear();
  path_ = DrawPath::immediate;
  reason_ = Reason::traced;
  open_ = !c_.compiling();
  c_.updateAttention();
}

void Immediate::closeRun() {
  if (c_.compiling()) {
    recordRun();
    return startRun();
  }
  open_ = false;
  drawRun();
  keepRunValues();
  c_.current.drawn();
  c_.updateAttention();
}

void Immediate::idle() {
  resumeExecuted();
  stream_.start(bit(kPosition), c_.current.all());
  c_.updateAttention();
}

void Immediate::recordRun() {
  Captured run = stream_.take();
  if (run.empty() && run.layout.mask == bit(kPosition)) return;
  SlotValues finals = c_.current.all();
  for (int s = kNormal; s < kSlotCount; ++s)
    if (run.layout.has(static_cast<Slot>(s)))
      std::memcpy(finals[static_cast<size_t>(s)].data(), stream_.get(run.layout, static_cast<Slot>(s)),
                  sizeOf(static_cast<Slot>(s)) * 4);
  GeometryRun* recorded = nullptr;
  try {
    recorded = &c_.lists.add(std::move(run), finals, std::move(inherited_), class_);
  } catch (...) {
    stream_.captured() = std::move(run);  // not yet moved from: stepAside() gives it to the real OpenGL
    throw;
  }
  inherited_.clear();
  c_.lists.executeAdded(*recorded);
}

void Immediate::loosen() {
  const Primitive open = stream_.openPrimitive();
  Captured run = stream_.take();
  SlotValues finals = c_.current.all();
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
  inside_ = Inside::nothing;
  startRun();
  c_.lists.append(op);
  recordMisuse();
}

void Immediate::leaveExecuted() {
  executed_ = inside_ == Inside::rasterised ? inside_ : Inside::nothing;
  inside_ = Inside::nothing;
}

void Immediate::keepRunValues() {
  for (int s = kNormal; s < kSlotCount; ++s) {
    const auto slot = static_cast<Slot>(s);
    if (stream_.has(slot) && slot != kMaterialNumber) setCurrent(slot, stream_.get(slot));
  }
  if (const MaterialChange* last = stream_.lastMaterial()) {
    c_.current.send(c_.real);
    sendMaterial(c_.real, *last);
    if (!insideBegin()) c_.latch.letGo(c_.real);
    c_.dirty |= kMaterial;
  }
}

KnownMesh Immediate::meshOfRun() {
  const double start = nowSeconds();
  const Captured& run = stream_.captured();
  KnownMesh known;
  const Hash128 content = run.hash();
  if (!c_.group().meshes.find(content, known)) {
    known = buildMesh(run);
    c_.group().meshes.put(content, known);
    ++c_.statistics.meshesBuilt;
    if (known.mesh) c_.statistics.meshBytes += known.mesh->sizeBytes;
  }
  c_.statistics.captureSeconds += nowSeconds() - start;
  return known;
}

void Immediate::drawRun() {
  const Captured& run = stream_.captured();
  if (run.empty()) return;
  weld_.sawRun(run.indices.empty() ? run.vertexCount : run.indices.size());
  const DrawTimer timer(c_.kinds());
  const Reason reason = c_.attempt([&] {
    if (c_.aside()) return Reason::failure;
    if (reason_ != Reason::traced) return reason_;
    const KnownMesh known = meshOfRun();
    const Reason fine = c_.triage(known, run.materials);
    if (fine == Reason::traced) c_.addInstance(known.mesh, run.layout.mask, run.materials);
    return fine;
  });
  const uint64_t triangles = countTriangles(run);
  if (reason == Reason::traced) return c_.countTraced(path_, triangles);
  if (c_.mayMeetPasses(class_)) c_.protect([&] { c_.meetPasses(sampleTriangles(run)); });
  if (c_.isPass(class_, reason)) c_.protect([&] { c_.rememberPass(meshOfRun()); });
  c_.countRaster(reason, path_, class_, triangles);
  c_.beforeRasterDraw(class_);
  c_.sendBuffers();
  replay(c_.real, run);
}

/// What has been set since the last vertex, into the fragment that is open.
void Immediate::sendRunValues() {
  for (int s = kNormal; s < kSlotCount; ++s) {
    const auto slot = static_cast<Slot>(s);
    if (stream_.has(slot) && slot != kMaterialNumber) sendAttribute(c_.real, slot, stream_.get(slot));
  }
  if (const MaterialChange* last = stream_.lastMaterial()) sendMaterial(c_.real, *last);
}

void Immediate::surrender() {
  Captured& run = stream_.captured();
  const bool open = inside_ == Inside::captured;
  GLuint fragment = 0;
  if (!c_.compiling()) c_.window.showLagged();
  c_.sendBuffers();          // glArrayElement may follow
  c_.current.send(c_.real);  // not into the list
  if (c_.compiling()) {
    fragment = c_.real.GenLists(1);
    c_.real.NewList(fragment, GL_COMPILE);
  }
  if (!c_.compiling() && (!run.empty() || open)) {
    if (open && c_.kinds()) c_.kinds()->start();
    c_.countRaster(c_.aside() ? Reason::failure : Reason::evaluators, path_, class_, countTriangles(run));
  }
  replay(c_.real, run);
  if (open) replayOpen(c_.real, run, stream_.openPrimitive());
  if (!c_.compiling()) {
    if (open) openPrimitive_ = stream_.openPrimitive();
    keepRunValues();
    c_.current.send(c_.real);  // legal inside glBegin too: what was set since the last vertex
  } else {
    sendRunValues();
    if (!open) c_.real.EndList();
  }
  inside_ = open ? Inside::rasterised : Inside::nothing;
  startRun();
  open_ = false;
  if (fragment && open)
    openFragment_ = fragment;
  else if (fragment)
    c_.lists.appendFragment(fragment);
}

}  // namespace gluray::gl
