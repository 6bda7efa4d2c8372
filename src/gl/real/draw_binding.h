// Binds a draw framebuffer during its lifetime. GL thread.
#pragma once
#include "gl/real/state_queries.h"

#include <GL/glext.h>

namespace gluray::gl {

/// During its lifetime `framebuffer` is the draw framebuffer. The destructor restores the previous one.
/// Raises no GL error if `framebuffer` exists.
class DrawBinding {
 public:
  DrawBinding(const RealGl& real, GLuint framebuffer)
      : real_(real), before_(drawFramebuffer(real)), changes_(before_ != framebuffer) {
    if (changes_) real.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  }
  ~DrawBinding() {
    if (changes_) real_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, before_);
  }
  DrawBinding(const DrawBinding&) = delete;
  DrawBinding& operator=(const DrawBinding&) = delete;

 private:
  const RealGl& real_;
  GLuint before_;
  bool changes_;
};

}  // namespace gluray::gl
