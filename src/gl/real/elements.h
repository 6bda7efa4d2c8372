// The vertices that a draw call uses. GL thread.
#pragma once
#include "gl/real/real.h"

#include <GL/gl.h>

#include <cstdint>

namespace gluray::gl {

inline bool isIndexType(GLenum type) {
  return type == GL_UNSIGNED_BYTE || type == GL_UNSIGNED_SHORT || type == GL_UNSIGNED_INT;
}

/// The vertices that a draw uses: `count` from `first`, or `count` indices of `type` at `indices`.
struct Elements {
  GLint first = 0;
  GLsizei count = 0;
  GLenum type = 0;                // 0: no indices
  const void* indices = nullptr;  // memory, or an offset into the element buffer
  GLint base = 0;                 // added to each index
  GLsizei instances = -1;         // -1: not an instanced draw
  GLuint baseInstance = 0;
  /// Number of instances; 1 without instancing.
  uint32_t repeats() const { return instances < 0 ? 1 : static_cast<uint32_t>(instances); }
};

/// Makes the draw with the real OpenGL.
void drawReal(const RealGl& real, GLenum mode, const Elements& elements);

}  // namespace gluray::gl
