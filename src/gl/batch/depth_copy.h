// Depth that a blit takes from one framebuffer object to another, copied instead. GL thread.
#pragma once
#include "gl/real.h"

#include <GL/gl.h>

namespace gluray::gl {

/// The arguments of a glBlitFramebuffer: corners in pixels.
struct Blit {
  GLint fromX0 = 0, fromY0 = 0, fromX1 = 0, fromY1 = 0, toX0 = 0, toY0 = 0, toX1 = 0, toY1 = 0;
  GLbitfield mask = 0;
  GLenum filter = GL_NEAREST;
};

/// Whether the real OpenGL would take the blit without an error, and its depth is what copying gives: from
/// one image to another, neither moved, scaled nor cut, alone in its image. No error may be pending.
/// `stencilsSet`: an image's stencil values may matter, where it has any; they are copied with its depth.
bool isDepthCopy(const RealGl& real, const Blit& blit, bool stencilsSet);

/// Copies it by glCopyImageSubData. False, with nothing done, where the real OpenGL refuses: formats or
/// sizes are no match.
bool copyDepth(const RealGl& real, const Blit& blit);

}  // namespace gluray::gl
