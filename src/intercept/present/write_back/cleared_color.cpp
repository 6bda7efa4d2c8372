#include "intercept/present/write_back/cleared_color.h"

#include "gl/real/state_queries.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>

namespace gluray::present {

std::optional<uint32_t> ClearedColor::bits(const gl::RealGl& real, const Features& features,
                                           const gl::ClearedTarget& cleared, PendingErrors& pending) {
  if (knows(cleared)) return bits_;
  pending = takeErrors(real);
  StateGuard guard(real, features);
  guard.plainPack();
  guard.readFrom(cleared.framebuffer, static_cast<GLenum>(gl::integer(real, GL_DRAW_BUFFER)));
  // The first pixel of the region that is in the framebuffer.
  real.ReadPixels(std::max(cleared.region.x, 0), std::max(cleared.region.y, 0), 1, 1, GL_RGBA,
                  GL_UNSIGNED_BYTE, &bits_);
  if (!takeErrors(real).empty()) return color_.reset(), std::nullopt;
  color_ = cleared.color;
  return bits_;
}

}  // namespace gluray::present
