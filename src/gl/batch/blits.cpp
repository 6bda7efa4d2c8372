// Blits between framebuffers, which look at what was drawn so far.
#include "gl/batch/depth_copy.h"
#include "gl/handlers.h"
#include "gl/stub.h"

namespace gluray::gl {
namespace {

void blitAsIs(const RealGl& real, const Blit& b) {
  real.BlitFramebuffer(b.fromX0, b.fromY0, b.fromX1, b.fromY1, b.toX0, b.toY0, b.toX1, b.toY1, b.mask,
                       b.filter);
}

}  // namespace

void Context::blit(Blit b) {
  const bool copies = (b.mask & GL_DEPTH_BUFFER_BIT) && settings_.quirks.has(Quirk::softwareDepthBlit) &&
                      activeQueries == 0 && isSoftwareBelow();
  if (copies) {
    if (const GLenum pending = real.GetError()) setError(pending);
    if (isDepthCopy(real, b, group_->stencilsSet) && copyDepth(real, b)) {
      b.mask &= ~GLbitfield{GL_DEPTH_BUFFER_BIT};
      noteUse(Quirk::softwareDepthBlit);
    }
  }
  if (b.mask) blitAsIs(real, b);
}

void blitFramebuffer(Context& c, GLint fromX0, GLint fromY0, GLint fromX1, GLint fromY1, GLint toX0,
                     GLint toY0, GLint toX1, GLint toY1, GLbitfield mask, GLenum filter) {
  const Blit blit{fromX0, fromY0, fromX1, fromY1, toX0, toY0, toX1, toY1, mask, filter};
  if (c.compiling()) {
    c.lists.recordFragment([&] { blitAsIs(c.real, blit); });
    c.lists.record([](Context& later) { later.touch(framebufferBound(later)); });
    return;
  }
  c.touch(framebufferBound(c));
  bool resolved = false;
  c.protect([&] { resolved = c.resolves.byBlit(blit); });
  if (!resolved) {
    c.beforeBlit();
    c.blit(blit);
  }
  c.forgetClear();
  c.touch(framebufferBound(c));  // another context that reads an image again must find it changed
}

}  // namespace gluray::gl
