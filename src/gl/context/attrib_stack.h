// glPushAttrib and glPopAttrib: the state that we save beside the real OpenGL's stack. A part of each
// Context, GL thread.
#pragma once
#include "gl/flush/flusher.h"

#include <GL/gl.h>

#include <vector>

namespace gluray::gl {

class ListCompiler;

class AttribStack {
 public:
  struct Parts {
    ShadowState& shadow;
    Flusher& flusher;
    ClearedFramebuffers& cleared;
    ListCompiler& lists;
  };
  explicit AttribStack(const Parts& parts) : p_(parts) {}

  void push(GLbitfield mask);
  void pop();

 private:
  struct Saved {
    GLbitfield mask;
    GLuint listBase;
  };

  std::vector<Saved> saved_;
  GLint deepest_ = 0;  // GL_MAX_ATTRIB_STACK_DEPTH; 0: not queried yet
  Parts p_;
};

}  // namespace gluray::gl
