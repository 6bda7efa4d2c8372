// Where a context is between glBegin and glEnd. Immediate writes it; others read it. GL thread.
#pragma once

#include <GL/gl.h>

#include <cstdint>

namespace gluray::gl {

struct BeginEnd {
  enum class Inside : uint8_t { nothing, captured, rasterised };
  Inside inside = Inside::nothing;    // of the program's primitive
  Inside executed = Inside::nothing;  // of the commands that the list being compiled has executed
  GLuint fragment = 0;                // real list that compiles the rest of a surrendered primitive

  bool isInside() const { return inside != Inside::nothing; }
  /// GL_COMPILE_AND_EXECUTE: whether the commands executed so far left a glBegin open. isInside() is then
  /// about the commands compiled.
  bool executedInside() const { return executed != Inside::nothing; }
  /// Whether the real OpenGL executes the program's glBegin/glEnd now, and does not just compile them.
  bool realIsInside() const { return (inside == Inside::rasterised && fragment == 0) || executedInside(); }
};

}  // namespace gluray::gl
