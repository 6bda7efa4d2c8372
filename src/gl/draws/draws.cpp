#include "gl/draws/draws.h"

namespace gluray::gl {

DrawPlan Draws::classify(DrawRequest& draw) const {
  DrawPlan plan{draw.classifyState(), {}};
  if (plan.reason != Reason::traced) return plan;
  plan.reason = p_.failsafe.attempt([&] {
    plan.mesh = draw.mesh();
    return draw.classifyMesh(plan.mesh);
  });
  return plan;
}

Fate Draws::execute(const DrawPlan& plan, DrawRequest& draw) {
  Reason reason = plan.reason;
  if (reason == Reason::traced) reason = p_.failsafe.attempt([&] { return draw.trace(plan.mesh); });
  return reason == Reason::traced ? Fate::traced : rasterise(draw, reason);
}

Fate Draws::rasterise(DrawRequest& draw, Reason reason) {
  if (draw.replace(reason)) return Fate::replaced;
  const DrawRequest::Load load = draw.load();
  draw.meetPasses(load.primitive, reason);
  p_.counts.rasterised(reason, load.path, load.primitive, load.triangles);
  if (load.more > 0) p_.counts.load(load.more);
  p_.raster.before(load.primitive);
  p_.shadow.sendBuffers();
  const Fate fate = draw.make();
  p_.shadow.current.drawnByReal();
  p_.shadow.latch.drawn();
  return fate;
}

void Draws::beginRasterised(DrawPath path, PrimitiveClass primitive, Reason reason) {
  p_.raster.noteUnsampledDraw(primitive, reason);
  p_.raster.before(primitive);
  p_.shadow.sendBuffers();  // glArrayElement may follow
  p_.shadow.latch.drawn();
  if (p_.counts.kinds()) p_.counts.kinds()->start();
  p_.counts.rasterised(reason, path, primitive, 0);
}

}  // namespace gluray::gl
