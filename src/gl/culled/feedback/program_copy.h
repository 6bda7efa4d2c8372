// A copy of one of the host's shader programs, changed to capture gl_Position by transform feedback. GL
// thread, context current.
#pragma once
#include "gl/glsl/program.h"
#include "gl/real/real.h"

#include <GL/gl.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace gluray::gl {

/// Built from the same texts of all shaders, with the same locations of attributes, so that the real OpenGL
/// computes the same positions.
class ProgramCopy {
 public:
  /// Links it. No error may be pending.
  ProgramCopy(const RealGl& real, const Program& original);
  /// Whether the copy is usable.
  bool works() const { return name_ != 0; }
  GLuint name() const { return name_; }
  /// Copies the values of the original's uniforms, including blocks. The copy must be in use.
  void copyUniforms(const RealGl& real) const;
  /// Deletes it.
  void release(const RealGl& real);

 private:
  struct Element {
    size_t from = 0;  // among all elements of the original's uniforms
    GLint location = -1;
  };
  bool link(const RealGl& real, const ShaderTexts& texts);
  /// Returns false if a uniform has a type that cannot be set.
  bool findUniforms(const RealGl& real);
  void findBlocks(const RealGl& real);

  const Program& original_;
  GLuint name_ = 0;
  std::vector<Element> elements_;
  std::vector<std::pair<GLuint, GLuint>> blocks_;  // the original's index, ours
};

}  // namespace gluray::gl
