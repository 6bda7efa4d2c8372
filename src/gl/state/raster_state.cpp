// Per-fragment operations and polygon state: the reasons against tracing, and the values that tracing needs.
#include "gl/real/blend_state.h"
#include "gl/real/clip_depths.h"
#include "gl/real/state_queries.h"
#include "gl/state/output_state.h"
#include "gl/state/state.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <glm/gtc/type_ptr.hpp>

namespace gluray::gl {
namespace {

/// The reason why blending prevents tracing, or Reason::traced if opaque surfaces replace the framebuffer's
/// colour. In that case sets unlessOpaque if other surfaces do not, and clears colorWrites.alpha if the
/// framebuffer keeps its alpha.
Reason blendReason(const RealGl& real, RasterState& raster) {
  if (!isOn(real, GL_BLEND)) return Reason::traced;
  const auto source = integer(real, GL_BLEND_SRC_RGB), destination = integer(real, GL_BLEND_DST_RGB);
  const auto sourceAlpha = integer(real, GL_BLEND_SRC_ALPHA),
             destinationAlpha = integer(real, GL_BLEND_DST_ALPHA);
  if (integer(real, GL_BLEND_EQUATION_RGB) != GL_FUNC_ADD ||
      integer(real, GL_BLEND_EQUATION_ALPHA) != GL_FUNC_ADD)
    return Reason::blend;
  const auto isOne = [](GLint f) { return f == GL_ONE || f == GL_SRC_ALPHA; };
  const auto isZero = [](GLint f) { return f == GL_ZERO || f == GL_ONE_MINUS_SRC_ALPHA; };
  if (!isOne(source) || !isZero(destination)) return Reason::blend;
  const bool keepsAlpha = sourceAlpha == GL_ZERO && destinationAlpha == GL_ONE;
  if (!keepsAlpha && (!isOne(sourceAlpha) || !isZero(destinationAlpha))) return Reason::blend;
  if (keepsAlpha) raster.colorWrites.alpha = false;
  if (source == GL_SRC_ALPHA || sourceAlpha == GL_SRC_ALPHA || destination == GL_ONE_MINUS_SRC_ALPHA ||
      destinationAlpha == GL_ONE_MINUS_SRC_ALPHA)
    raster.unlessOpaque = Reason::blend;
  return Reason::traced;
}

scene::AlphaTest readAlphaTest(const RealGl& real) {
  scene::AlphaTest test;
  if (!isOn(real, GL_ALPHA_TEST)) return test;
  using Function = scene::AlphaTest;
  switch (integer(real, GL_ALPHA_TEST_FUNC)) {
    case GL_NEVER: test.function = Function::never; break;
    case GL_LESS: test.function = Function::less; break;
    case GL_LEQUAL: test.function = Function::lessOrEqual; break;
    case GL_EQUAL: test.function = Function::equal; break;
    case GL_GEQUAL: test.function = Function::greaterOrEqual; break;
    case GL_GREATER: test.function = Function::greater; break;
    case GL_NOTEQUAL: test.function = Function::notEqual; break;
    default: break;
  }
  real.GetFloatv(GL_ALPHA_TEST_REF, &test.reference);
  return test;
}

scene::Fog readFog(const RealGl& real, const RareState& has) {
  scene::Fog fog;
  if (!isOn(real, GL_FOG)) return fog;
  switch (integer(real, GL_FOG_MODE)) {
    case GL_LINEAR: fog.mode = scene::Fog::linear; break;
    case GL_EXP2: fog.mode = scene::Fog::exp2; break;
    default: fog.mode = scene::Fog::exp; break;
  }
  fog.fromCoordinates = has.fogCoord && integer(real, GL_FOG_COORD_SRC) == GL_FOG_COORD;
  fog.clampsSum = !has.fogsWholeSum;
  real.GetFloatv(GL_FOG_DENSITY, &fog.density);
  real.GetFloatv(GL_FOG_START, &fog.start);
  real.GetFloatv(GL_FOG_END, &fog.end);
  GLfloat color[4] = {};
  real.GetFloatv(GL_FOG_COLOR, color);
  fog.color = {color[0], color[1], color[2]};
  return fog;
}

/// The reason why fog prevents tracing: its distance is not the distance from the viewer's plane.
Reason fogReason(const RealGl& real, const RareState& has) {
  const bool unusual = has.fogDistance && isOn(real, GL_FOG) &&
                       integer(real, GL_FOG_DISTANCE_MODE_NV) != GL_EYE_PLANE_ABSOLUTE_NV;
  return unusual ? Reason::fog : Reason::traced;
}

/// The reason why per-fragment operations other than the depth test and fog prevent tracing. Cheap and common
/// queries come first.
Reason otherFragmentReason(const RealGl& real, const RareState& has, RasterState& raster) {
  GLboolean mask[4] = {};
  real.GetBooleanv(GL_COLOR_WRITEMASK, mask);
  if (!mask[0] && !mask[1] && !mask[2] && !mask[3]) return Reason::colorMask;
  raster.colorWrites = {mask[0] != 0, mask[1] != 0, mask[2] != 0, mask[3] != 0};
  if (isOn(real, GL_STENCIL_TEST)) return Reason::stencil;
  if (isOn(real, GL_COLOR_LOGIC_OP)) return Reason::logicOp;
  if (raster.program == 0 && programPipeline(real, has.pipelines) != 0) return Reason::program;
  if (raster.program == 0 && has.assemblyPrograms &&
      (isOn(real, GL_VERTEX_PROGRAM_ARB) || isOn(real, GL_FRAGMENT_PROGRAM_ARB)))
    return Reason::program;
  if (isOn(real, GL_SAMPLE_ALPHA_TO_COVERAGE) || isOn(real, GL_SAMPLE_COVERAGE) ||
      isOn(real, GL_SAMPLE_ALPHA_TO_ONE) || (has.sampleMask && isOn(real, GL_SAMPLE_MASK)))
    return Reason::multisampleState;
  if (const Reason rare = rareReason(real, has); rare != Reason::traced) return rare;
  if (!raster.writesDepth) return Reason::depthMask;
  return blendReason(real, raster);
}

Reason fragmentReason(const RealGl& real, const RareState& has, RasterState& raster) {
  raster.butDepthFunc = Reason::depthFunc;
  if (has.fixedFunction && integer(real, GL_RENDER_MODE) != GL_RENDER)
    return raster.butDepthFunc = Reason::renderMode;
  if (!isOn(real, GL_DEPTH_TEST)) return raster.butDepthFunc = Reason::noDepthTest;
  const bool isUsual = raster.depthFunc == GL_LESS || raster.depthFunc == GL_LEQUAL;
  if (isUsual || raster.isReversed()) raster.butDepthFunc = otherFragmentReason(real, has, raster);
  const Reason reason = isUsual || raster.isReversed() ? raster.butDepthFunc : Reason::depthFunc;
  // Reasons that still allow tracing: as surfaces, or as layers.
  const bool traced = reason == Reason::traced || reason == Reason::depthMask || reason == Reason::blend;
  return traced && fogReason(real, has) != Reason::traced ? Reason::fog : reason;
}

/// Whether OpenGLs differ in what they offset: as specified, no filled polygon, but Mesa's llvmpipe offsets
/// them, too (seen in 22.3).
bool offsetsOnlyOthers(const RealGl& real, const RasterState& raster) {
  return !raster.offsetFill && (raster.offsetFactor != 0 || raster.offsetUnits != 0) &&
         (isOn(real, GL_POLYGON_OFFSET_LINE) || isOn(real, GL_POLYGON_OFFSET_POINT));
}

Reason polygonReason(const RealGl& real, const RareState& has, const RasterState& raster) {
  GLint mode[2] = {GL_FILL, GL_FILL};
  real.GetIntegerv(GL_POLYGON_MODE, mode);
  if (mode[0] != GL_FILL || mode[1] != GL_FILL) return Reason::polygonMode;
  if (has.fixedFunction && isOn(real, GL_POLYGON_STIPPLE)) return Reason::polygonStipple;
  if (isOn(real, GL_POLYGON_SMOOTH)) return Reason::polygonSmooth;
  return offsetsOnlyOthers(real, raster) ? Reason::polygonOffset : Reason::traced;
}

scene::CullFace readCull(const RealGl& real) {
  if (!isOn(real, GL_CULL_FACE)) return scene::CullFace::none;
  switch (integer(real, GL_CULL_FACE_MODE)) {
    case GL_FRONT: return scene::CullFace::front;
    case GL_BACK: return scene::CullFace::back;
    default: return scene::CullFace::both;
  }
}

}  // namespace

void readRaster(const RealGl& real, const RareState& has, RasterState& raster, scene::Fog& fog) {
  raster.depthFunc = static_cast<GLenum>(integer(real, GL_DEPTH_FUNC));
  raster.writesDepth = integer(real, GL_DEPTH_WRITEMASK) != 0;
  raster.depthsFromZero = hasDepthsFromZero(real, has);
  raster.offsetFill = isOn(real, GL_POLYGON_OFFSET_FILL);
  real.GetFloatv(GL_POLYGON_OFFSET_FACTOR, &raster.offsetFactor);
  real.GetFloatv(GL_POLYGON_OFFSET_UNITS, &raster.offsetUnits);
  raster.unlessOpaque = Reason::traced;
  raster.colorWrites = {};
  raster.program = isPresent(real.UseProgram) ? static_cast<GLuint>(integer(real, GL_CURRENT_PROGRAM)) : 0;
  raster.reason = fragmentReason(real, has, raster);
  // A draw that tests and writes depth, and replaces colour, merges by depth with pending traced surfaces.
  raster.orderFree = (raster.reason == Reason::traced || raster.reason == Reason::fog ||
                      raster.reason == Reason::program || raster.reason == Reason::renderMode) &&
                     !isOn(real, GL_BLEND) && raster.writesDepth;
  // Programs of a pipeline are not inspected. They may write memory, and then the order of draws matters.
  if (raster.program == 0 && raster.reason == Reason::program && programPipeline(real, has.pipelines) != 0)
    raster.orderFree = false;
  const bool blended = raster.reason == Reason::depthMask || raster.reason == Reason::blend ||
                       (raster.reason == Reason::traced && raster.unlessOpaque != Reason::traced);
  const bool open = raster.butDepthFunc == Reason::traced;
  const Reason polygon = blended || open ? polygonReason(real, has, raster) : Reason::traced;
  if (raster.reason == Reason::traced) raster.reason = polygon;
  if (open && polygon != Reason::traced) raster.butDepthFunc = polygon;
  raster.layers = blended && polygon == Reason::traced && !raster.isReversed() && !raster.depthsFromZero
                      ? readBlending(real, raster.writesDepth)
                      : std::nullopt;
  const bool moved = raster.offsetFill && (raster.offsetFactor != 0 || raster.offsetUnits != 0);
  if (raster.isReversed() && moved && raster.reason == Reason::traced) raster.reason = Reason::reversedDepth;
  raster.firstVertexProvokes =
      has.provokingVertex && integer(real, GL_PROVOKING_VERTEX) != GL_LAST_VERTEX_CONVENTION;
  raster.multisample = isOn(real, GL_MULTISAMPLE);
  if (has.fixedFunction) {
    raster.alphaTest = readAlphaTest(real);
    fog = readFog(real, has);
  }
  raster.cull = readCull(real);
  raster.frontFaceCcw = integer(real, GL_FRONT_FACE) == GL_CCW;
}

}  // namespace gluray::gl
