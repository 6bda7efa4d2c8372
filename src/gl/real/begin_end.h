// Whether a context is between glBegin and glEnd. Immediate writes it; others read it. GL thread.
#pragma once

#include <GL/gl.h>

#include <cstdint>

namespace gluray::gl {

struct BeginEnd {
  enum class Inside : uint8_t { nothing, captured, rasterised };
  Inside inside = Inside::nothing;    // the primitive of the program's calls
  Inside executed = Inside::nothing;  // of the commands that the compiled list has executed
  GLuint fragment = 0;                // real list that compiles the uncaptured rest of a primitive

  bool isInside() const { return inside != Inside::nothing; }
  /// GL_COMPILE_AND_EXECUTE: whether the commands executed so far left a glBegin open. isInside() then
  /// describes the commands compiled.
  bool executedInside() const { return executed != Inside::nothing; }
  /// Whether the real OpenGL is between glBegin and glEnd now, in commands that it executes, not only
  /// compiles.
  bool realIsInside() const { return (inside == Inside::rasterised && fragment == 0) || executedInside(); }
};

}  // namespace gluray::gl
