// Selects texture units of the real OpenGL. GL thread, context current.
#pragma once
#include "gl/real/state_queries.h"

#include <GL/gl.h>
#include <GL/glext.h>

namespace gluray::gl {

/// Selects texture units, and makes the previous one active again at the end of its life.
class ActiveUnit {
 public:
  explicit ActiveUnit(const RealGl& real) : real_(real), saved_(integer(real, GL_ACTIVE_TEXTURE)) {}
  ~ActiveUnit() { select(static_cast<GLenum>(saved_)); }
  ActiveUnit(const ActiveUnit&) = delete;
  ActiveUnit& operator=(const ActiveUnit&) = delete;
  void select(GLenum unit) {
    if (isPresent(real_.ActiveTexture)) real_.ActiveTexture(unit);
  }

 private:
  const RealGl& real_;
  GLint saved_;
};

}  // namespace gluray::gl
