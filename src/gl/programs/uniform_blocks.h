// Uniform blocks of programs: the buffers behind them. GL thread, context current.
#pragma once
#include "gl/real.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <cstddef>
#include <vector>

namespace gluray::gl {

/// What is bound to a binding point of GL_UNIFORM_BUFFER; size 0: all of the buffer.
struct BlockBinding {
  GLuint binding = 0, buffer = 0;
  GLint64 start = 0, size = 0;
};
BlockBinding boundBlock(const RealGl& real, GLuint binding);

/// A block's bytes, and where the program looks for them.
struct UniformBlock {
  GLuint binding = 0;
  std::vector<std::byte> contents;
};

/// The active blocks of a program that have a buffer, as they are now.
std::vector<UniformBlock> readBlocks(const RealGl& real, GLuint program);

}  // namespace gluray::gl
