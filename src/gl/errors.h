// The errors that glGetError answers: ours and the real OpenGL's in the order of their calls. A part of each
// Context, GL thread.
#pragma once
#include "gl/real.h"

#include <GL/gl.h>

namespace gluray::gl {

class Immediate;

class Errors {
 public:
  Errors(const RealGl& real, const Immediate& immediate) : real_(real), immediate_(immediate) {}

  /// The first error since the program asked stays, ours or the real OpenGL's.
  void set(GLenum error);
  /// What glGetError answers: then there is none.
  GLenum take();
  /// Before questions that may set errors of their own: one of the program's that is pending becomes ours.
  void keepPending() {
    if (const GLenum pending = real_.GetError()) set(pending);
  }

 private:
  const RealGl& real_;
  const Immediate& immediate_;
  GLenum error_ = GL_NO_ERROR;
};

}  // namespace gluray::gl
