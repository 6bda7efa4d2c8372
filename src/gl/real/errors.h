// The error that glGetError returns: the first one raised, by us or by the real OpenGL. A part of each
// Context, GL thread.
#pragma once
#include "gl/real/begin_end.h"
#include "gl/real/real.h"

#include <GL/gl.h>

namespace gluray::gl {

class Errors {
 public:
  Errors(const RealGl& real, const BeginEnd& beginEnd) : real_(real), beginEnd_(beginEnd) {}

  /// Records `error` unless an earlier error, ours or the real OpenGL's, is pending.
  void set(GLenum error);
  /// Returns the pending error for glGetError and clears it.
  GLenum takeError();
  /// Call before queries that may raise errors: moves the program's pending error here.
  void keepPending() {
    if (const GLenum pending = real_.GetError()) set(pending);
  }
  /// Returns the oldest error of the real OpenGL and clears all its errors. Call after keepPending() and
  /// after our own calls that may raise errors.
  GLenum takeReal();

 private:
  const RealGl& real_;
  const BeginEnd& beginEnd_;
  GLenum error_ = GL_NO_ERROR;
};

}  // namespace gluray::gl
