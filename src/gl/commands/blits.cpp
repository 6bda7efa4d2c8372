// glBlitFramebuffer, which reads everything drawn so far: resolves waiting images, copies depth, or blits.
#include "gl/context/handlers.h"
#include "gl/context/stub.h"
#include "gl/framebuffers/depth_copy.h"
#include "gl/real/debug_silence.h"

namespace gluray::gl {
namespace {

void blitAsIs(const RealGl& real, const Blit& b) {
  real.BlitFramebuffer(b.fromX0, b.fromY0, b.fromX1, b.fromY1, b.toX0, b.toY0, b.toX1, b.toY1, b.mask,
                       b.filter);
}

/// Makes a blit that ResolveDraws::byBlit() has not made. Call Flusher::beforeBlit() first.
void blit(Context& c, Blit b) {
  const RealGl& real = c.real;
  const bool copies = (b.mask & GL_DEPTH_BUFFER_BIT) &&
                      c.shadow.settings.quirks.has(Quirk::softwareDepthBlit) && c.shadow.activeQueries == 0 &&
                      c.shadow.isSoftwareBelow();
  if (copies) {
    c.errors.keepPending();
    const DebugSilence silence(real, c.shadow.rare().debugOutput);
    if (isDepthCopy(real, c.shadow.images, b, c.shadow.group.stencilsSet) && copyDepth(real, b)) {
      b.mask &= ~GLbitfield{GL_DEPTH_BUFFER_BIT};
      noteUse(Quirk::softwareDepthBlit);
    }
  }
  if (b.mask) blitAsIs(real, b);
}

}  // namespace

void blitFramebuffer(Context& c, GLint fromX0, GLint fromY0, GLint fromX1, GLint fromY1, GLint toX0,
                     GLint toY0, GLint toX1, GLint toY1, GLbitfield mask, GLenum filter) {
  const Blit what{fromX0, fromY0, fromX1, fromY1, toX0, toY0, toX1, toY1, mask, filter};
  if (c.lists.compiling()) {
    c.lists.recordFragment([&] { blitAsIs(c.real, what); });
    c.lists.record([](Context& later) { later.touch(framebufferBound(later)); });
    return;
  }
  c.touch(framebufferBound(c));
  bool resolved = false;
  c.immediate.closeRunOutsideBegin();
  c.protect([&] { resolved = c.resolves.byBlit(what); });
  if (!resolved) {
    c.flusher.beforeBlit(mask);
    blit(c, what);
  }
  c.cleared.forget();
  c.touch(framebufferBound(c));  // again: other contexts that read the images must see the change
}

}  // namespace gluray::gl
