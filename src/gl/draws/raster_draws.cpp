#include "gl/draws/raster_draws.h"

#include "gl/flush/resolve_draws.h"
#include "gl/framebuffers/composed_views.h"
#include "gl/layers/layer_draws.h"
#include "gl/real/errors.h"
#include "gl/real/state_queries.h"
#include "gl/window/window_frames.h"

namespace gluray::gl {
namespace {

/// Takes away the polygon offsets of lines and points while the batch is drawn with its own offset: Mesa's
/// llvmpipe applies them to filled polygons, too (seen in 22.3).
class WithoutOtherOffsets {
 public:
  explicit WithoutOtherOffsets(const RealGl& real) : real_(real) {
    for (const GLenum offset : {GL_POLYGON_OFFSET_LINE, GL_POLYGON_OFFSET_POINT})
      if (isOn(real, offset)) real.Disable(offset), taken_.push_back(offset);
  }
  ~WithoutOtherOffsets() {
    for (const GLenum offset : taken_) real_.Enable(offset);
  }
  WithoutOtherOffsets(const WithoutOtherOffsets&) = delete;
  WithoutOtherOffsets& operator=(const WithoutOtherOffsets&) = delete;

 private:
  const RealGl& real_;
  std::vector<GLenum> taken_;
};

}  // namespace

RasterDraws::Needs RasterDraws::needsOf(PrimitiveClass kind, Reason reason) const {
  Needs needs;
  needs.meets = p_.classifier.meetsDepth(kind) && p_.surfaces.passes.anyUnder(p_.shadow.modelview());
  if (!p_.classifier.leavesDepth(kind)) return needs;
  // One pass of several, or a surface that other frames trace.
  needs.mesh = reason == Reason::colorMask || reason == Reason::passes || reason == Reason::smallScene;
  if (needs.mesh || !hasFixedVertices()) return needs;
  needs.leaves = p_.surfaces.passes.asksForFixed();
  needs.unsampled = !needs.leaves;
  return needs;
}

bool RasterDraws::hasFixedVertices() const {
  const GLuint program = p_.shadow.raster().program;
  return program == 0 ||
         p_.failsafe.protect([&] { return readsFixedVertices(p_.shadow.recognise(program)->program); });
}

bool RasterDraws::needsVertices(PrimitiveClass kind, Reason reason) const {
  return needsOf(kind, reason).any();
}

void RasterDraws::noteUnsampledDraw(PrimitiveClass kind, Reason reason) {
  if (needsOf(kind, reason).unsampled) addUnsampledFixedDraw();
}

void RasterDraws::leave(std::vector<Triangle> triangles) {
  if (p_.classifier.fillsArePushedBack())  // which triangles are filled is unknown
    p_.surfaces.passes.rasterisedFixed(p_.shadow.modelview(), triangles, depthPlaceOf(p_.shadow), true);
  p_.surfaces.passes.rasterisedFixed(p_.shadow.modelview(), std::move(triangles), depthPlaceOf(p_.shadow),
                                     p_.classifier.isPushedBack());
}

void RasterDraws::addUnsampledFixedDraw() {
  p_.failsafe.protect([&] { p_.surfaces.passes.addUnsampledFixedDraw(depthPlaceOf(p_.shadow)); });
}

void RasterDraws::remember(const KnownMesh& known) {
  if (known.mesh)
    p_.surfaces.passes.drawn(known.mesh, p_.shadow.modelview(), MultipassSurfaces::How::rasterised,
                             depthPlaceOf(p_.shadow), p_.classifier.isPushedBack());
}

void RasterDraws::meet(std::span<const Triangle> triangles) {
  p_.failsafe.protect([&] {
    p_.flusher.settleBelow(p_.shadow.target().samples);
    rasteriseMet(p_.surfaces.passes.meets(p_.shadow.modelview(), triangles, depthPlaceOf(p_.shadow),
                                          p_.classifier.increasesDepth()));
  });
}

void RasterDraws::rasteriseMet(MultipassSurfaces::Meeting meeting) {
  const std::vector<DepthRedraw> redraws = p_.surfaces.passes.takeTraced();
  // Layers that wait meet the depths that were there when they were drawn.
  if (!redraws.empty() && meeting != MultipassSurfaces::Meeting::pending && !p_.pending.batch.empty() &&
      p_.pending.batch.key().layers == BatchKey::Layers::drawn)
    p_.flusher.flush();
  for (const DepthRedraw& redraw : redraws) {
    const WithoutOtherOffsets guard(p_.shadow.real);
    p_.cleared.forget();
    PresentTarget target{.core = p_.shadow.info.core, .rasterise = true, .depthAgain = true};
    if (redraw.clipFromObject) target.byMatrix = {redraw.mesh, *redraw.clipFromObject};
    p_.shadow.current.shelve(p_.shadow.real);
    const PresentResult result = p_.pending.presenter.present(p_.shadow.real, redraw.snapshot, target);
    p_.shadow.latch.restore(p_.shadow.real);
    if (result.pendingError != GL_NO_ERROR) p_.shadow.errors.set(result.pendingError);
  }
  if (meeting == MultipassSurfaces::Meeting::pending) {
    const WithoutOtherOffsets guard(p_.shadow.real);
    p_.flusher.present(Reason::passes);
  }
}

void RasterDraws::before(PrimitiveClass kind) {
  p_.failsafe.protect([&] { p_.composed.settle(); });
  if (p_.window.lags() || p_.window.lacks()) p_.failsafe.protect([&] { p_.window.meetDraw(); });
  Batch& batch = p_.pending.batch;
  // The pending batch was just found to be coplanar with this draw: rasterise both.
  if (p_.surfaces.coplanar.takeFound() && !batch.empty() &&
      (batch.key().layers == BatchKey::Layers::none || batch.key().layers == BatchKey::Layers::drawn) &&
      batch.key().framebuffer == p_.shadow.target().framebuffer)
    p_.failsafe.protect([&] {
      const WithoutOtherOffsets guard(p_.shadow.real);
      p_.flusher.present(Reason::coincident);
    });
  if (p_.resolves.any()) p_.failsafe.protect([&] { p_.resolves.meetRasterDraw(); });
  if (p_.layers.held.pending()) p_.failsafe.protect([&] { p_.layers.peels.meetRasterDraw(); });
  if (!batch.empty()) {
    const RasterState& raster = p_.shadow.raster();
    // Lines and points on a surface have its depth: drawing order decides, unless the surface was pushed
    // back.
    const bool coplanar = kind != PrimitiveClass::surfaces && batch.key().offset == scene::PolygonOffset{};
    // Summed layers round in drawing order, as floats. Drawn layers blend in drawing order.
    const bool seenThrough =
        batch.key().layers == BatchKey::Layers::summed || batch.key().layers == BatchKey::Layers::drawn;
    // What the program counts or stores depends on the depths against which its fragments are tested.
    const bool writes = raster.program != 0 && p_.shadow.recognise(raster.program)->program.writes;
    // If only one of the two writes a channel, the channel keeps the value of that draw or of an earlier one.
    const bool channels = !(raster.colorWrites == batch.key().colorWrites);
    // Depths merge in any order only if both draws keep the smaller ones or both the larger ones.
    const bool opposite = raster.isReversed() != batch.key().keepsLargest();
    if (!raster.orderFree || coplanar || seenThrough || writes || channels || opposite) p_.flusher.flush();
  }
  p_.failsafe.protect([&] { p_.relighting.finish(Relighting::Place::sampling); });
  clearBelow_ = p_.cleared.target();
  if (p_.composed.waits() && kind == PrimitiveClass::surfaces) [[unlikely]]
    p_.failsafe.protect([&] { p_.composed.drawing(); });
  noteDepths();
}

void RasterDraws::noteDepths() {
  if (p_.shadow.isDirty(kRaster)) return p_.cleared.forget();
  const RasterState& raster = p_.shadow.raster();
  const bool writes = raster.writesDepth && raster.butDepthFunc != Reason::noDepthTest;
  const bool keeps = !writes || raster.depthFunc == GL_EQUAL || raster.depthFunc == GL_NEVER;
  const bool smaller = raster.depthFunc == GL_LESS || raster.depthFunc == GL_LEQUAL;
  p_.cleared.drawing(!keeps && !raster.isReversed(), !keeps && !smaller);
}

}  // namespace gluray::gl
