#include "gl/culled/cullable_state.h"

#include "gl/state/state_queries.h"

#include <GL/glext.h>

namespace gluray::gl {
namespace {

bool isMode(GLenum mode, bool core) {
  return mode == GL_TRIANGLES || mode == GL_TRIANGLE_STRIP || mode == GL_TRIANGLE_FAN ||
         (mode == GL_QUADS && !core);
}

/// Whether the offset may bring surfaces nearer than their vertices are.
bool offsetsNearer(const RasterState& raster) {
  if (!raster.offsetFill) return false;
  return raster.isReversed() ? raster.offsetFactor > 0 || raster.offsetUnits > 0
                             : raster.offsetFactor < 0 || raster.offsetUnits < 0;
}

}  // namespace

Reason cullableState(const ShadowState& shadow, GLenum mode) {
  const State& state = shadow.state;
  const RasterState& raster = state.raster;
  const RealGl& real = shadow.real;
  if (!isMode(mode, shadow.info.core)) return Reason::mode;
  if (shadow.activeQueries > 0) return Reason::query;
  // Fog changes colours only; a stipple discards pixels.
  const Reason reason = raster.butDepthFunc;
  if (reason != Reason::traced && reason != Reason::fog && reason != Reason::polygonStipple) return reason;
  // Without multisampling all samples of a pixel may take a depth from anywhere in it, outside the triangle.
  if (state.target.samples > 1 && !raster.multisample) return Reason::multisampleState;
  if (state.target.reason != Reason::traced && state.target.reason != Reason::framebuffer)
    return state.target.reason;
  if (offsetsNearer(raster)) return Reason::offsetNearer;
  if (isPresent(real.DrawBuffers) && integer(real, GL_DRAW_BUFFER0 + 1) != GL_NONE)
    return Reason::drawBuffers;
  return Reason::traced;
}

bool hasByteColors(const ShadowState& shadow) {
  const TargetState& target = shadow.state.target;
  if (target.reason != Reason::traced || target.wideColors || target.encodes) return false;
  if (shadow.state.rare.fixedFunction) return target.eightBits;
  const GLenum buffer = target.framebuffer != 0 ? target.drawBuffer : GLenum{GL_BACK_LEFT};
  const auto bits = [&](GLenum name) {
    GLint value = 0;
    shadow.real.GetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, buffer, name, &value);
    return value;
  };
  const GLint alpha = bits(GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE);
  return bits(GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE) == 8 && bits(GL_FRAMEBUFFER_ATTACHMENT_GREEN_SIZE) == 8 &&
         bits(GL_FRAMEBUFFER_ATTACHMENT_BLUE_SIZE) == 8 && (alpha == 8 || alpha == 0);
}

Reason cullableBlending(const ShadowState& shadow, bool opaque) {
  if (!isOn(shadow.real, GL_BLEND)) return Reason::traced;
  // Colours that are floats may be infinite: then 0 times what was there is no number.
  return opaque && !shadow.state.target.wideColors ? Reason::traced : Reason::blend;
}

}  // namespace gluray::gl
