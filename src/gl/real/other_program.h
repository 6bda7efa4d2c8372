// Uses one of GLuRay's shader programs temporarily instead of the program's own. GL thread, context current.
#pragma once
#include "gl/real/real.h"

#include <GL/gl.h>

#include <array>
#include <cstddef>
#include <vector>

namespace gluray::gl {

/// During its lifetime, use() selects other shader programs. The destructor restores the previous one with
/// the state that glUseProgram discards: a deleted program stays alive, and subroutine uniforms keep their
/// values (OpenGL 4.6, 7.1 and 7.10). Requires OpenGL 2.0, and no transform feedback that is active and not
/// paused. Raises no error.
class OtherProgram {
 public:
  /// Throws std::bad_alloc.
  explicit OtherProgram(const RealGl& real);
  ~OtherProgram();
  OtherProgram(const OtherProgram&) = delete;
  OtherProgram& operator=(const OtherProgram&) = delete;

  /// Uses `program`; 0 selects fixed function, even if a program pipeline is bound.
  void use(GLuint program);

 private:
  static constexpr size_t kStages = 6;  // shader stages

  GLuint ofStage(size_t stage) const;
  void readSubroutines(int version);
  void keepAlive(int version);

  const RealGl& real_;
  const GLuint program_;
  GLuint inUse_;
  GLuint pipeline_ = 0,
         holder_ = 0;     // program pipelines: the bound one, and ours that holds a deleted program
  bool unbound_ = false;  // whether pipeline_ is not bound
  std::array<std::vector<GLuint>, kStages> subroutines_;  // values, by stage and location
};

}  // namespace gluray::gl
