// Questions to the real OpenGL, answered as values. Private to gl/, GL thread.
#pragma once
#include "gl/real.h"

#include <GL/gl.h>

namespace gluray::gl {

inline GLint integer(const RealGl& real, GLenum name) {
  GLint value = 0;
  real.GetIntegerv(name, &value);
  return value;
}

inline bool isOn(const RealGl& real, GLenum capability) { return real.IsEnabled(capability) == GL_TRUE; }

}  // namespace gluray::gl
