#include "gl/batch/clears.h"

#include "gl/real/state_queries.h"

#include <GL/glext.h>

#include <algorithm>
#include <cmath>

namespace gluray::gl {
namespace {

constexpr GLbitfield kColorAndDepth = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT;

}  // namespace

/// Computes in 64 bits: regions may be as large as int allows.
bool contains(const scene::Region& outer, const scene::Region& inner) {
  const auto end = [](int start, int size) { return int64_t{start} + size; };
  return outer.x <= inner.x && outer.y <= inner.y && end(inner.x, inner.width) <= end(outer.x, outer.width) &&
         end(inner.y, inner.height) <= end(outer.y, outer.height);
}

float farthestHit(GLenum depthFunc, float resolution) {
  if (depthFunc == GL_LEQUAL) return 1;
  return std::min(std::nextafter(1.0f, 0.0f), 1 - resolution / 2);
}

bool clearsInFull(const RealGl& real, const RareState& has, GLbitfield mask) {
  if (has.rasterizerDiscard && isOn(real, GL_RASTERIZER_DISCARD)) return false;
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

bool clearsAll(const RealGl& real, const RareState& has) {
  GLdouble depth = 0;
  real.GetDoublev(GL_DEPTH_CLEAR_VALUE, &depth);
  return depth == 1 && clearsInFull(real, has, kColorAndDepth);
}

bool clearsWindow(const RealGl& real, const RareState& has, GLbitfield mask) {
  const bool encodes = has.framebufferSrgb && isOn(real, GL_FRAMEBUFFER_SRGB);
  return !encodes && !isOn(real, GL_SCISSOR_TEST) && clearsInFull(real, has, mask);
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
