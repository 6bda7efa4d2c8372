// Copies depth by glCopyImageSubData instead of glBlitFramebuffer, which is slow in software OpenGLs. Used by
// blits.cpp, GL thread.
#pragma once
#include "gl/real/real.h"
#include "gl/state/attached_images.h"

#include <GL/gl.h>

namespace gluray::gl {

/// The arguments of a glBlitFramebuffer: corners in pixels.
struct Blit {
  GLint fromX0 = 0, fromY0 = 0, fromX1 = 0, fromY1 = 0, toX0 = 0, toY0 = 0, toX1 = 0, toY1 = 0;
  GLbitfield mask = 0;
  GLenum filter = GL_NEAREST;
};

/// Whether the blit raises no error, and its depth part equals a plain copy between two images: not moved,
/// scaled or clipped. No error may be pending. `stencilsSet`: stencil values, which the copy would include,
/// may matter.
bool isDepthCopy(const RealGl& real, AttachedImages& images, const Blit& blit, bool stencilsSet);

/// Copies the depth by glCopyImageSubData. Returns false, with nothing done, if formats or sizes do not
/// match.
bool copyDepth(const RealGl& real, const Blit& blit);

}  // namespace gluray::gl
