// glPushAttrib and glPopAttrib: what we keep beside the real OpenGL's stack. A part of each Context, GL
// thread.
#pragma once
#include <GL/gl.h>

#include <vector>

namespace gluray::gl {

class Context;

class AttribStack {
 public:
  explicit AttribStack(Context& context) : c_(context) {}
  AttribStack(const AttribStack&) = delete;
  AttribStack& operator=(const AttribStack&) = delete;

  void push(GLbitfield mask);
  void pop();

 private:
  struct Saved {
    GLbitfield mask;
    GLuint listBase;
  };

  Context& c_;
  std::vector<Saved> saved_;
  GLint deepest_ = 0;  // 0: not known yet
};

}  // namespace gluray::gl
