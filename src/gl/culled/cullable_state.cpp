#include "gl/culled/cullable_state.h"

#include "gl/real/state_queries.h"
#include "gl/state/output_state.h"

#include <GL/glext.h>

#include <array>

namespace gluray::gl {
namespace {

bool isMode(GLenum mode, bool core) {
  return mode == GL_TRIANGLES || mode == GL_TRIANGLE_STRIP || mode == GL_TRIANGLE_FAN ||
         (mode == GL_QUADS && !core);
}

/// Whether the polygon offset may move surfaces nearer than their vertices.
bool offsetsNearer(const RealGl& real, const RasterState& raster) {
  // Mesa's llvmpipe offsets filled polygons in each of these cases (seen in 22.3).
  if (!raster.offsetFill && !isOn(real, GL_POLYGON_OFFSET_LINE) && !isOn(real, GL_POLYGON_OFFSET_POINT))
    return false;
  return raster.isReversed() ? raster.offsetFactor > 0 || raster.offsetUnits > 0
                             : raster.offsetFactor < 0 || raster.offsetUnits < 0;
}

/// Whether something other than fixed function draws although no program is in use.
bool hasOtherPrograms(ShadowState& shadow) {
  const RealGl& real = shadow.real;
  if (programPipeline(real, shadow.rare().pipelines) != 0) return true;
  return shadow.rare().assemblyPrograms &&
         (isOn(real, GL_VERTEX_PROGRAM_ARB) || isOn(real, GL_FRAGMENT_PROGRAM_ARB));
}

}  // namespace

CullReason hideableState(ShadowState& shadow, GLenum mode, bool& isTested) {
  const RasterState& raster = shadow.raster();
  const RealGl& real = shadow.real;
  isTested = isOn(real, GL_DEPTH_TEST) && (raster.depthFunc == GL_LESS || raster.depthFunc == GL_LEQUAL ||
                                           raster.depthFunc == GL_EQUAL || raster.isReversed());
  if (!isMode(mode, shadow.info.core)) return CullReason::mode;
  if (shadow.activeQueries > 0) return CullReason::query;
  if (!shadow.info.core && integer(real, GL_RENDER_MODE) != GL_RENDER) return CullReason::renderMode;
  if (isOn(real, GL_STENCIL_TEST)) return CullReason::stencil;
  if (raster.program == 0 && hasOtherPrograms(shadow)) return CullReason::program;
  if (const Reason rare = rareReason(real, shadow.rare()); rare != Reason::traced) return cullReason(rare);
  if (raster.depthsFromZero) return CullReason::clipControl;
  std::array<GLint, 2> polygons{GL_FILL, GL_FILL};
  real.GetIntegerv(GL_POLYGON_MODE, polygons.data());
  if (polygons[0] != GL_FILL || polygons[1] != GL_FILL) return CullReason::polygonMode;
  if (isOn(real, GL_POLYGON_SMOOTH)) return CullReason::polygonSmooth;
  if (shadow.target().samples > 1 && !raster.multisample) return CullReason::multisampleState;
  return offsetsNearer(real, raster) ? CullReason::offsetNearer : CullReason::culled;
}

CullReason cullableState(ShadowState& shadow, GLenum mode) {
  const RasterState& raster = shadow.raster();
  const TargetState& target = shadow.target();
  const RealGl& real = shadow.real;
  if (!isMode(mode, shadow.info.core)) return CullReason::mode;
  if (shadow.activeQueries > 0) return CullReason::query;
  // A stipple discards pixels.
  const Reason reason = raster.butDepthFunc;
  if (reason != Reason::traced && reason != Reason::polygonStipple) return cullReason(reason);
  if (raster.depthsFromZero) return CullReason::clipControl;
  // Without multisampling, all samples of a pixel may get a depth from any place in it, even outside the
  // triangle.
  if (target.samples > 1 && !raster.multisample) return CullReason::multisampleState;
  if (target.reason != Reason::traced && target.reason != Reason::framebuffer)
    return cullReason(target.reason);
  if (offsetsNearer(real, raster)) return CullReason::offsetNearer;
  return hasMoreDrawBuffers(real) ? CullReason::drawBuffers : CullReason::culled;
}

bool hasByteColors(ShadowState& shadow) {
  const TargetState& target = shadow.target();
  return target.reason == Reason::traced && !target.wideColors && !target.encodes && target.eightBits;
}

CullReason cullableBlending(ShadowState& shadow, bool opaque) {
  if (!isOn(shadow.real, GL_BLEND)) return CullReason::culled;
  // Float colours may be infinite: then 0 times the colour below is not a number.
  return opaque && !shadow.target().wideColors ? CullReason::culled : CullReason::blend;
}

}  // namespace gluray::gl
