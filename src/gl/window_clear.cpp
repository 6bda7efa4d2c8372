#include "gl/window_clear.h"

#include "gl/state_queries.h"

#include <GL/glext.h>

namespace gluray::gl {

bool clearsWindow(const RealGl& real, const RareState& has, GLbitfield mask) {
  if (has.rasterizerDiscard && isOn(real, GL_RASTERIZER_DISCARD)) return false;
  if (isOn(real, GL_SCISSOR_TEST)) return false;
  if (mask & GL_COLOR_BUFFER_BIT) {
    GLboolean open[4] = {};
    real.GetBooleanv(GL_COLOR_WRITEMASK, open);
    if (!open[0] || !open[1] || !open[2] || !open[3]) return false;
  }
  if (mask & GL_DEPTH_BUFFER_BIT && integer(real, GL_DEPTH_WRITEMASK) == 0) return false;
  constexpr GLint kStencilBits = 0xff;
  return !(mask & GL_STENCIL_BUFFER_BIT) ||
         (integer(real, GL_STENCIL_WRITEMASK) & kStencilBits) == kStencilBits;
}

WindowClear windowClear(const RealGl& real, GLbitfield mask) {
  WindowClear clear;
  clear.mask = mask;
  real.GetFloatv(GL_COLOR_CLEAR_VALUE, clear.color.data());
  real.GetDoublev(GL_DEPTH_CLEAR_VALUE, &clear.depth);
  real.GetIntegerv(GL_STENCIL_CLEAR_VALUE, &clear.stencil);
  return clear;
}

}  // namespace gluray::gl
