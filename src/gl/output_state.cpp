#include "gl/output_state.h"

#include "gl/state_queries.h"

#include <GL/glext.h>

#include <initializer_list>

namespace gluray::gl {
namespace {

bool allOff(const RealGl& real, std::initializer_list<GLenum> capabilities) {
  for (const GLenum capability : capabilities)
    if (isOn(real, capability)) return false;
  return true;
}

/// Whether every fragment of a filled triangle gets as far as depth test and blending with all its channels.
bool isOpen(const RealGl& real, const RareState& has) {
  if (!allOff(real, {GL_STENCIL_TEST, GL_COLOR_LOGIC_OP})) return false;
  if (has.framebufferSrgb && isOn(real, GL_FRAMEBUFFER_SRGB)) return false;
  if (has.rasterizerDiscard && isOn(real, GL_RASTERIZER_DISCARD)) return false;
  if (has.fixedFunction && isOn(real, GL_ALPHA_TEST)) return false;
  GLboolean mask[4] = {};
  real.GetBooleanv(GL_COLOR_WRITEMASK, mask);
  GLint polygonMode[2] = {GL_FILL, GL_FILL};
  real.GetIntegerv(GL_POLYGON_MODE, polygonMode);
  return mask[0] && mask[1] && mask[2] && mask[3] && polygonMode[0] == GL_FILL;
}

}  // namespace

bool writesThrough(const RealGl& real, const RareState& has) {
  return allOff(real, {GL_DEPTH_TEST, GL_BLEND, GL_CULL_FACE}) && isOpen(real, has);
}

bool keepsLargest(const RealGl& real, const RareState& has) {
  return !isOn(real, GL_DEPTH_TEST) && isOn(real, GL_BLEND) &&
         integer(real, GL_BLEND_EQUATION_RGB) == GL_MAX && integer(real, GL_BLEND_EQUATION_ALPHA) == GL_MAX &&
         isOpen(real, has);
}

}  // namespace gluray::gl
