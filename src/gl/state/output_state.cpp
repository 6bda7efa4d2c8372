#include "gl/state/output_state.h"

#include "gl/real/clip_depths.h"
#include "gl/real/state_queries.h"

#include <GL/glext.h>

#include <initializer_list>

namespace gluray::gl {
namespace {

bool allOff(const RealGl& real, std::initializer_list<GLenum> capabilities) {
  for (const GLenum capability : capabilities)
    if (isOn(real, capability)) return false;
  return true;
}

/// Whether exactly the first two draw buffers are in use, and both have float formats.
bool drawsTwoOfFloats(const RealGl& real) {
  GLint most = 0;
  real.GetIntegerv(GL_MAX_DRAW_BUFFERS, &most);
  for (int i = 0; i < most; ++i) {
    const auto buffer = static_cast<GLenum>(integer(real, GL_DRAW_BUFFER0 + static_cast<GLenum>(i)));
    if ((buffer != GL_NONE) != (i < 2)) return false;
    if (buffer == GL_NONE) continue;
    GLint type = 0;
    real.GetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, buffer,
                                             GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, &type);
    if (type != GL_FLOAT) return false;
  }
  return true;
}

/// Whether a blend parameter of draw buffers 0 and 1 is `wanted`. Without per-buffer blending, checks the
/// common one.
bool blendIs(const RealGl& real, GLenum name, GLint wanted) {
  if (!isPresent(real.BlendFunci)) return integer(real, name) == wanted;
  for (GLuint i = 0; i < 2; ++i) {
    GLint value = 0;
    real.GetIntegeri_v(name, i, &value);
    if (value != wanted) return false;
  }
  return true;
}

bool blendIsOn(const RealGl& real) {
  if (!isPresent(real.IsEnabledi)) return isOn(real, GL_BLEND);
  return real.IsEnabledi(GL_BLEND, 0) && real.IsEnabledi(GL_BLEND, 1);
}

/// Whether all fragments of filled triangles reach depth test and blending, with all channels written.
bool isOpen(const RealGl& real, const RareState& has) {
  if (!allOff(real, {GL_STENCIL_TEST, GL_COLOR_LOGIC_OP})) return false;
  if (has.framebufferSrgb && isOn(real, GL_FRAMEBUFFER_SRGB)) return false;
  if (rareReason(real, has) != Reason::traced || hasDepthsFromZero(real, has)) return false;
  if (has.fixedFunction && (isOn(real, GL_ALPHA_TEST) || isOn(real, GL_POLYGON_STIPPLE))) return false;
  GLboolean mask[4] = {};
  real.GetBooleanv(GL_COLOR_WRITEMASK, mask);
  GLint polygonMode[2] = {GL_FILL, GL_FILL};
  real.GetIntegerv(GL_POLYGON_MODE, polygonMode);
  return mask[0] && mask[1] && mask[2] && mask[3] && polygonMode[0] == GL_FILL;
}

}  // namespace

Reason rareReason(const RealGl& real, const RareState& has) {
  if (has.depthClamp && isOn(real, GL_DEPTH_CLAMP)) return Reason::depthClamp;
  if (has.depthBounds && isOn(real, GL_DEPTH_BOUNDS_TEST_EXT)) return Reason::depthClamp;
  if (has.rasterizerDiscard && isOn(real, GL_RASTERIZER_DISCARD)) return Reason::transformFeedback;
  if (has.feedbackActive && integer(real, GL_TRANSFORM_FEEDBACK_ACTIVE)) return Reason::transformFeedback;
  if (has.clipControl && integer(real, GL_CLIP_ORIGIN) != GL_LOWER_LEFT) return Reason::clipControl;
  GLfloat clamp = 0;
  if (has.offsetClamp) real.GetFloatv(GL_POLYGON_OFFSET_CLAMP, &clamp);
  return clamp != 0 ? Reason::depthClamp : Reason::traced;
}

bool writesThrough(const RealGl& real, const RareState& has) {
  return allOff(real, {GL_DEPTH_TEST, GL_BLEND, GL_CULL_FACE}) && isOpen(real, has);
}

bool keepsLargest(const RealGl& real, const RareState& has) {
  return !isOn(real, GL_DEPTH_TEST) && isOn(real, GL_BLEND) &&
         integer(real, GL_BLEND_EQUATION_RGB) == GL_MAX && integer(real, GL_BLEND_EQUATION_ALPHA) == GL_MAX &&
         isOpen(real, has);
}

bool addsUp(const RealGl& real, const RareState& has, const RasterState& raster) {
  const bool tested = isOn(real, GL_DEPTH_TEST) && !integer(real, GL_DEPTH_WRITEMASK) &&
                      (raster.depthFunc == GL_LESS || raster.depthFunc == GL_LEQUAL);
  return tested && blendIsOn(real) && blendIs(real, GL_BLEND_EQUATION_RGB, GL_FUNC_ADD) &&
         blendIs(real, GL_BLEND_EQUATION_ALPHA, GL_FUNC_ADD) && blendIs(real, GL_BLEND_SRC_RGB, GL_ONE) &&
         blendIs(real, GL_BLEND_DST_RGB, GL_ONE) && blendIs(real, GL_BLEND_SRC_ALPHA, GL_ZERO) &&
         blendIs(real, GL_BLEND_DST_ALPHA, GL_ONE_MINUS_SRC_ALPHA) && isOpen(real, has) &&
         drawsTwoOfFloats(real);
}

}  // namespace gluray::gl
