// The source of a program's shaders, asked of the real OpenGL when it is first needed. GL thread, context
// current.
#pragma once
#include "gl/real.h"

#include <string>
#include <string_view>
#include <vector>

namespace gluray::gl {

class ProgramSource {
 public:
  ProgramSource(const RealGl& real, GLuint program) : real_(real), program_(program) {}

  /// Texts of the shaders that are attached, one after the other, without comments.
  const std::string& text();
  /// The same as statements (glsl_statements.h); empty where no shader is attached.
  const std::vector<std::string_view>& statements();

 private:
  template <class Each>
  void eachShader(Each&& each) const;

  const RealGl& real_;
  GLuint program_;
  bool hasText_ = false, hasStatements_ = false;
  std::string text_, code_;  // code_: what statements_ are views of
  std::vector<std::string_view> statements_;
};

}  // namespace gluray::gl
