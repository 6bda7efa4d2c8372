// Full-screen passes of programs that we do ourselves, because a software OpenGL takes longer over them than
// we over the whole picture. A part of each Context, GL thread.
#pragma once
#include "gl/arrays/elements.h"
#include "gl/batch/flusher.h"

#include <GL/gl.h>

namespace gluray::gl {

class FullscreenPasses {
 public:
  struct Parts {
    ShadowState& shadow;
    const Failsafe& failsafe;
    ClearedFramebuffers& cleared;
    Flusher& flusher;
    ResolveDraws& resolves;
  };
  explicit FullscreenPasses(const Parts& parts) : p_(parts) {}

  /// Does what the draw would do where it is such a pass. False: draw it.
  bool replace(GLenum mode, const Elements& elements);

 private:
  /// The texture that covers the draw framebuffer's colours with level 0; 0: there is none.
  GLuint wholeTarget(GLenum mode, const Elements& elements, const scene::Region& region) const;
  bool antialiasInto(GLuint attachment, const scene::Region& region, bool instead);

  Parts p_;
};

}  // namespace gluray::gl
