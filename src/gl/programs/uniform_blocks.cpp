#include "gl/programs/uniform_blocks.h"

#include "gl/real/state_queries.h"

#include <algorithm>

namespace gluray::gl {

BlockBinding boundBlock(const RealGl& real, GLuint binding) {
  BlockBinding bound;
  GLint buffer = 0;
  real.GetIntegeri_v(GL_UNIFORM_BUFFER_BINDING, binding, &buffer);
  bound.binding = binding;
  bound.buffer = static_cast<GLuint>(buffer);
  if (buffer == 0) return bound;
  real.GetInteger64i_v(GL_UNIFORM_BUFFER_START, binding, &bound.start);
  real.GetInteger64i_v(GL_UNIFORM_BUFFER_SIZE, binding, &bound.size);
  return bound;
}

std::vector<UniformBlock> readBlocks(const RealGl& real, GLuint program) {
  std::vector<UniformBlock> blocks;
  GLint count = 0;
  real.GetProgramiv(program, GL_ACTIVE_UNIFORM_BLOCKS, &count);
  const auto saved = static_cast<GLuint>(integer(real, GL_COPY_READ_BUFFER_BINDING));
  for (GLuint i = 0; i < static_cast<GLuint>(count); ++i) {
    GLint binding = 0, wanted = 0;
    GLint64 there = 0;
    real.GetActiveUniformBlockiv(program, i, GL_UNIFORM_BLOCK_BINDING, &binding);
    real.GetActiveUniformBlockiv(program, i, GL_UNIFORM_BLOCK_DATA_SIZE, &wanted);
    const BlockBinding bound = boundBlock(real, static_cast<GLuint>(binding));
    if (bound.buffer == 0) continue;
    real.BindBuffer(GL_COPY_READ_BUFFER, bound.buffer);
    real.GetBufferParameteri64v(GL_COPY_READ_BUFFER, GL_BUFFER_SIZE, &there);
    const GLint64 readable = std::min<GLint64>(wanted, there - bound.start);
    UniformBlock block{bound.binding, std::vector<std::byte>(static_cast<size_t>(std::max(wanted, 0)))};
    if (readable > 0)
      real.GetBufferSubData(GL_COPY_READ_BUFFER, static_cast<GLintptr>(bound.start),
                            static_cast<GLsizeiptr>(readable), block.contents.data());
    blocks.push_back(std::move(block));
  }
  real.BindBuffer(GL_COPY_READ_BUFFER, saved);
  return blocks;
}

}  // namespace gluray::gl
