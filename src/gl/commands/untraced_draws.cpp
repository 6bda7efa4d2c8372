// Draws that are certain to be rasterised, by programs that no family describes. They are checked as little
// as possible: programs make thousands of them in a frame.
#include "gl/capture/captured_vertices.h"
#include "gl/commands/array_draws.h"
#include "gl/context/handlers.h"

namespace gluray::gl {

namespace {

/// Whether draws of the program in use are certain to be rasterised. May throw std::bad_alloc.
bool isUntraced(Context& c) {
  if (c.untraced.inUse() == Reason::traced) return false;
  const bool isAsked = c.counts.kinds() || c.surfaces.objects.asked() || c.shadow.settings.light.rasterised;
  if (isAsked || !c.pending.batch.empty() || !c.layers.held.idle()) return false;
  // Surfaces drawn in several passes are recognised by their vertices.
  if (c.untraced.readsFixedVertices() && c.surfaces.passes.asksForFixed()) return false;
  return !c.surfaces.passes.any() && c.untraced.areAll();
}

/// Whether the shaders may read fixed function's vertices. The programs of a pipeline are not inspected.
bool mayReadFixedVertices(Context& c) {
  if (c.untraced.inUse() != Reason::traced) return c.untraced.readsFixedVertices();
  if (c.info().core) return false;
  return c.shadow.arrays().vertex.enabled;
}

}  // namespace

bool drawsUntraced(Context& c) {
  return c.protect([&] { return isUntraced(c); });
}

void beforeUntraced(Context& c, GLenum mode, DrawPath path, uint64_t triangles) {
  c.immediate.closeRunIfOpen();
  c.shadow.refresh(kViewport | kTarget);
  c.protect([&] {
    const Reason ofContext = c.classifier.ofContext(), inUse = c.untraced.inUse();
    const Reason ofProgram = inUse == Reason::traced ? Reason::program : inUse;  // a pipeline has no program
    const Reason reason = mode > GL_POLYGON || ofContext == Reason::traced ? ofProgram : ofContext;
    c.counts.rasterised(reason, path, kindOf(mode), triangles);
    if (mayReadFixedVertices(c)) c.surfaces.passes.addUnsampledFixedDraw(depthPlaceOf(c.shadow));
  });
  c.raster.before(kindOf(mode));
  c.shadow.sendBuffers();
}

void rememberUntraced(Context& c, GLenum mode, const Elements& e) {
  if (mode > GL_POLYGON) return;
  const uint64_t count = countTriangles(mode, static_cast<uint64_t>(e.count));
  c.protect([&] { c.surfaces.passes.rasterisedUnseen(depthPlaceOf(c.shadow), count); });
}

bool drawUntraced(Context& c, GLenum mode, const Elements& e) {
  if (!drawsUntraced(c)) return false;
  const CulledDraws::Part part = c.culled.mayLeaveOut(e);
  if (part == CulledDraws::Part::clusters) return false;
  const bool mayHide = part == CulledDraws::Part::whole;
  if (mayHide)
    c.shadow.refresh(kRaster);  // the direction in which depths change must be known
  else
    c.culled.count(e);
  beforeUntraced(c, mode, pathOf(e), trianglesOf(mode, e));
  rememberUntraced(c, mode, e);
  if (!mayHide || !c.culled.draw(mode, e)) drawReal(c.real, mode, e);
  return true;
}

}  // namespace gluray::gl
