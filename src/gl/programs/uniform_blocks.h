// Reads the buffers behind shader programs' uniform blocks. GL thread, context current.
#pragma once
#include "gl/real/real.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <cstddef>
#include <vector>

namespace gluray::gl {

/// The buffer range bound to a binding point of GL_UNIFORM_BUFFER, in bytes; size 0: the whole buffer.
struct BlockBinding {
  GLuint binding = 0, buffer = 0;
  GLint64 start = 0, size = 0;
};
BlockBinding boundBlock(const RealGl& real, GLuint binding);

/// A block's contents and the binding point where the shader program reads them.
struct UniformBlock {
  GLuint binding = 0;
  std::vector<std::byte> contents;
};

/// The current contents of the shader program's active blocks that have a buffer.
std::vector<UniformBlock> readBlocks(const RealGl& real, GLuint program);

}  // namespace gluray::gl
