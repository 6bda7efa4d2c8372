#include "gl/commands/fixed_arrays_draw.h"

#include "gl/commands/array_draws.h"
#include "gl/commands/raster_light.h"
#include "gl/context/context.h"

namespace gluray::gl {

bool FixedArraysDraw::hasKnownVertices() const {
  return c_.shadow.arrays().vertex.enabled && elements_.instances < 0;
}

Reason FixedArraysDraw::classifyState() {
  if (!hasKnownVertices()) return Reason::arrayState;
  if (mode_ > GL_POLYGON) return Reason::program;  // adjacency and patches need shaders
  const Reason reason = c_.classifier.classify(classOf(mode_));
  if (reason != Reason::traced) return reason;
  const ArrayState& arrays = c_.shadow.arrays();
  return arrays.reason == Reason::traced && c_.shadow.isRestarted(arrays, elements_) ? Reason::arrayState
                                                                                     : arrays.reason;
}

KnownMesh FixedArraysDraw::mesh() { return meshOf(c_, c_.shadow.arrays(), mode_, elements_); }

Reason FixedArraysDraw::classifyMesh(const KnownMesh& mesh) { return c_.classifier.classify(mesh, {}); }

Reason FixedArraysDraw::trace(const KnownMesh& mesh) {
  c_.filler.add(mesh.mesh, slotsOf(c_.shadow.arrays()), {});
  c_.counts.traced(pathOf(elements_), mesh.mesh->triangleCount);
  c_.shadow.drawnTraced();
  return Reason::traced;
}

void FixedArraysDraw::meetPasses(PrimitiveClass primitive, Reason reason) {
  if (!c_.raster.needsVertices(primitive, reason)) return c_.raster.noteUnsampledDraw(primitive, reason);
  const ArrayState& arrays = c_.shadow.arrays();
  if (!arrays.vertex.enabled || arrays.reason != Reason::traced || c_.shadow.isRestarted(arrays, elements_))
    return;
  c_.raster.meetPasses(
      primitive, reason, [&] { return sampleTriangles(c_.real, arrays, mode_, elements_); },
      [&] { return mesh(); });
}

DrawRequest::Load FixedArraysDraw::load() {
  return {pathOf(elements_), kindOf(mode_), countTriangles(mode_, static_cast<uint64_t>(elements_.count))};
}

Fate FixedArraysDraw::make() {
  const bool known = hasKnownVertices();
  const bool culled = known && c_.culled.draw(mode_, elements_);
  if (!culled) drawReal(c_.real, mode_, elements_);
  if (known) lightRasterised(c_, mode_, elements_);
  return culled ? Fate::culled : Fate::rasterised;
}

}  // namespace gluray::gl
