#include "gl/program_state/current_program.h"

#include "gl/programs/match.h"

namespace gluray::gl {

std::shared_ptr<const KnownProgram> CurrentProgram::known(GLuint name) const {
  return group_.program(real_, name, info_.families ? *info_.families : builtInFamilies());
}

GLuint CurrentProgram::name() const {
  if (!isPresent(real_.UseProgram)) return 0;
  GLint name = 0;
  real_.GetIntegerv(GL_CURRENT_PROGRAM, &name);
  return static_cast<GLuint>(name);
}

bool drawsImpostors(const KnownProgram& program, GLenum mode) {
  if (mode != GL_POINTS && mode != GL_LINES) return false;
  if (!program.family || !program.family->impostors.given() || program.family->impostors.sent) return false;
  return (mode == GL_LINES) == (program.family->impostors.shape == scene::Shape::tubes);
}

bool CurrentProgram::drawsImpostors(GLenum mode) const {
  if (mode != GL_POINTS && mode != GL_LINES) return false;
  const GLuint inUse = name();
  if (inUse == 0) return false;
  const auto program = known(inUse);
  return program && gl::drawsImpostors(*program, mode);
}

bool CurrentProgram::drawsVolumes() const {
  const GLuint inUse = name();
  if (inUse == 0) return false;
  const auto program = known(inUse);
  return program && program->family && program->family->volume.given();
}

}  // namespace gluray::gl
