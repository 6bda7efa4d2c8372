// Full-screen passes (FXAA, resolve) that we make in place of the host program, because a software OpenGL
// takes longer for them than we for the whole image. A part of each Context, GL thread.
#pragma once
#include "gl/flush/flusher.h"
#include "gl/flush/relighting.h"
#include "gl/real/elements.h"

#include <GL/gl.h>

namespace gluray::gl {

class FullscreenPasses {
 public:
  struct Parts {
    ShadowState& shadow;
    const Failsafe& failsafe;
    ClearedFramebuffers& cleared;
    PendingBatch& pending;
    Flusher& flusher;
    Relighting& relighting;
    ResolveDraws& resolves;
  };
  explicit FullscreenPasses(const Parts& parts) : p_(parts) {}

  /// Makes the pass if the draw is one. False: draw it.
  bool replace(GLenum mode, const Elements& elements);

 private:
  /// The texture whose level 0 is the draw framebuffer's colour, if the draw covers all of `region`; 0: none.
  GLuint wholeTarget(GLenum mode, const Elements& elements, const scene::Region& region) const;
  bool antialiasInto(GLuint attachment, const scene::Region& region, bool instead);

  Parts p_;
};

}  // namespace gluray::gl
