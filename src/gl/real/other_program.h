// Uses one of GLuRay's shader programs temporarily instead of the program's own. GL thread, context current.
#pragma once
#include "gl/real/real.h"

#include <GL/gl.h>

#include <array>
#include <cstddef>
#include <vector>

namespace gluray::gl {

/// While it lives, use() may use other shader programs. The destructor uses the one from before again, with
/// what glUseProgram takes from it: a deleted one lives on, and subroutine uniforms keep their values (OpenGL
/// 4.6, 7.1 and 7.10). Requires OpenGL 2.0, and no transform feedback that is active and not paused. Raises
/// no error.
class OtherProgram {
 public:
  /// Throws std::bad_alloc.
  explicit OtherProgram(const RealGl& real);
  ~OtherProgram();
  OtherProgram(const OtherProgram&) = delete;
  OtherProgram& operator=(const OtherProgram&) = delete;

  /// 0: fixed function, also where a program pipeline is bound.
  void use(GLuint program);

 private:
  static constexpr size_t kStages = 6;  // that shaders are of

  GLuint ofStage(size_t stage) const;
  void readSubroutines(int version);
  void keepAlive(int version);

  const RealGl& real_;
  const GLuint program_;
  GLuint inUse_;
  GLuint pipeline_ = 0,
         holder_ = 0;     // program pipelines: the bound one, and ours that holds a deleted program
  bool unbound_ = false;  // whether pipeline_ is not bound
  std::array<std::vector<GLuint>, kStages> subroutines_;  // of each stage, by location
};

}  // namespace gluray::gl
