// glPushAttrib and glPopAttrib: what we keep beside the real OpenGL's stack. A part of each Context, GL
// thread.
#pragma once
#include "gl/context_part.h"

#include <GL/gl.h>

#include <vector>

namespace gluray::gl {

class AttribStack : public ContextPart {
 public:
  using ContextPart::ContextPart;

  void push(GLbitfield mask);
  void pop();

 private:
  struct Saved {
    GLbitfield mask;
    GLuint listBase;
  };

  std::vector<Saved> saved_;
  GLint deepest_ = 0;  // 0: not known yet
};

}  // namespace gluray::gl
